#include "estimation/vertical.h"

#include <math.h>

#include "common/limit.h"

// Three equal poles: changes slower than this time come from the barometer, faster ones from the acceleration.
static const float time_s = 2.0F;

static const float longest_without_baro_s = 2.0F;

// Flight does not bring an aircraft that far from its estimate: the simulator moved it.
static const float far_m = 40.0F;
static const float far_for_s = 0.25F;

static const float largest_bias_m_s2 = 1.0F;

void vertical_init(vertical_filter_t* filter)
{
    *filter = (vertical_filter_t){.has_begun = false};
}

static void begin(vertical_filter_t* filter, float altitude_m)
{
    *filter = (vertical_filter_t){.altitude_m = altitude_m, .bias_m_s2 = filter->bias_m_s2, .has_begun = true};
}

void vertical_update(vertical_filter_t* filter, const vertical_input_t* input, float dt_s)
{
    filter->without_baro_s = input->has_altitude ? 0.0F : filter->without_baro_s + dt_s;
    if (!filter->has_begun || !vertical_is_known(filter))
    {
        filter->has_begun = false;
        if (input->has_altitude)
        {
            begin(filter, input->altitude_m);
        }
        return;
    }
    const float acceleration_m_s2 = input->has_acceleration ? input->acceleration_m_s2 + filter->bias_m_s2 : 0.0F;
    filter->altitude_m += filter->speed_m_s * dt_s + acceleration_m_s2 * dt_s * dt_s / 2.0F;
    filter->speed_m_s += acceleration_m_s2 * dt_s;
    if (!input->has_altitude)
    {
        return;
    }
    const float error_m = input->altitude_m - filter->altitude_m;
    filter->disagreed_s = fabsf(error_m) > far_m ? filter->disagreed_s + dt_s : 0.0F;
    if (filter->disagreed_s >= far_for_s)
    {
        begin(filter, input->altitude_m);
        return;
    }
    if (filter->disagreed_s > 0.0F)
    {
        return; // a single outlier, unless it persists
    }
    const float share = dt_s / time_s;
    filter->altitude_m += 3.0F * share * error_m;
    filter->speed_m_s += 3.0F * share * error_m / time_s;
    if (input->has_acceleration)
    {
        const float bias_m_s2 = filter->bias_m_s2 + share * error_m / (time_s * time_s);
        filter->bias_m_s2 = limit_to(bias_m_s2, -largest_bias_m_s2, largest_bias_m_s2);
    }
}

bool vertical_is_known(const vertical_filter_t* filter)
{
    return filter->has_begun && filter->without_baro_s <= longest_without_baro_s;
}
