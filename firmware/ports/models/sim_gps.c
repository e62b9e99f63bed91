#include "sim_gps.h"

#include <math.h>
#include <string.h>

#include "common/units.h"
#include "navigation/geodesy.h"

static const double rad_per_deg = 0.017453292519943295;
static const float period_s = 0.2F;

static const float horizontal_error_m = 1.2F;
static const float vertical_error_m = 2.5F;
static const float error_time_s = 60.0F;
static const float speed_noise_kt = 0.15F;

static const int usual_satellites = 10;

void sim_gps_init(sim_gps_t* model, uint32_t seed)
{
    memset(model, 0, sizeof *model);
    sim_noise_init(&model->noise, seed);
}

/// The number as ASCII digits, as the receiver sends it: units in the low byte, tens in the next.
static int32_t satellite_digits(int count)
{
    const int tens = count / 10;
    return ('0' + count % 10) | (tens > 0 ? ('0' + tens) << 8 : 0);
}

static message_gps_t solve(sim_gps_t* model, const sim_truth_t* truth)
{
    sim_noise_t* const noise = &model->noise;
    sim_noise_wander(noise, &model->north_error_m, horizontal_error_m, error_time_s, period_s);
    sim_noise_wander(noise, &model->east_error_m, horizontal_error_m, error_time_s, period_s);
    sim_noise_wander(noise, &model->up_error_m, vertical_error_m, error_time_s, period_s);
    sim_noise_wander(noise, &model->satellites_wander, 0.8F, error_time_s, period_s);
    const float speed_kt = truth->ground_speed_m_s / M_S_PER_KT + sim_noise_normal(noise, speed_noise_kt);
    const double east_m_per_deg = GEODESY_M_PER_DEG * cos(truth->latitude_deg * rad_per_deg);
    return (message_gps_t){
        .latitude_deg = (float)(truth->latitude_deg + (double)model->north_error_m / GEODESY_M_PER_DEG),
        .longitude_deg = (float)(truth->longitude_deg + (double)model->east_error_m / fmax(east_m_per_deg, 1.0)),
        .altitude_m = truth->altitude_m + model->up_error_m,
        .speed_kt = fmaxf(0.0F, speed_kt),
        .heading_deg = truth->track_deg,
        .satellites = satellite_digits(usual_satellites + (int)lroundf(model->satellites_wander)),
        .fix = '1',
        .valid = 'A',
    };
}

message_gps_t sim_gps_read(sim_gps_t* model, const sim_truth_t* truth, float dt_s)
{
    model->age_s += dt_s;
    if (!model->has_solution)
    {
        model->computed = solve(model, truth);
        model->put_out = model->computed;
        model->age_s = 0.0F;
        model->has_solution = true;
    }
    // Half a step of tolerance, because the age is a sum of rounded steps.
    if (model->age_s + dt_s / 2.0F >= period_s)
    {
        model->age_s = 0.0F;
        model->put_out = model->computed;
        model->computed = solve(model, truth);
    }
    return model->put_out;
}
