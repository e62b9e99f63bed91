#include "estimation/gravity.h"

#include <math.h>

#include "common/limit.h"
#include "common/units.h"

/// A reading that differs from g by this share of it is a gust, a bump or an impact, and does not show where down is.
static const float strength_tolerance = 0.3F;

gravity_t gravity_felt(const gravity_input_t* input)
{
    const vector_t motion = {.x = input->airspeed_m_s};
    const vector_t turning = vector_cross(input->rate_rad_s, motion);
    const vector_t flight = {turning.x + input->acceleration_m_s2, turning.y, turning.z};
    const vector_t down_m_s2 = vector_difference(flight, input->force_m_s2);
    const float strength = vector_length(down_m_s2);
    const float deviation = fabsf(strength / GRAVITY_M_S2 - 1.0F);
    if (deviation >= strength_tolerance)
    {
        return (gravity_t){.down = {.z = 1.0F}, .trust = 0.0F};
    }
    return (gravity_t){
        .down = vector_scaled(down_m_s2, 1.0F / strength),
        .trust = limit_to(1.0F - deviation / strength_tolerance, 0.0F, 1.0F),
    };
}
