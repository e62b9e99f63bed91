#include "control/line_follow.h"

#include <math.h>

#include "common/angle.h"
#include "common/limit.h"
#include "common/units.h"

static const float steepest_approach_rad = 1.3F; ///< angle to the line far away from it
static const float half_pi = 1.57079633F;
static const float slowest_m_s = 5.0F; ///< over the ground; below it the field would have no width
static const float aileron_limit = 0.7F;
static const float integral_limit = 0.2F;
static const float integral_window_deg = 10.0F; ///< of bank error: a larger one is a roll under way
// slow enough that a new target moves no surface by a twentieth of its travel in one step, faster than any turn needs
static const float roll_rate_limit_deg_s = 60.0F;

void line_follow_engage(line_follow_state_t* state, float roll_deg)
{
    *state = (line_follow_state_t){.roll_d_deg = roll_deg};
}

/// Bank that the field asks for.
static float bank_deg(const line_follow_gains_t* gains, const line_follow_target_t* target,
                      const line_follow_input_t* input)
{
    const float speed_m_s = fmaxf(input->ground_speed_m_s, slowest_m_s);
    const float width_m = speed_m_s * gains->approach_time_s;
    const float distance = half_pi * target->right_m / (width_m * steepest_approach_rad);
    const float off_rad = angle_to_rad(angle_wrap_180(input->track_deg - target->course_deg));
    const float approach_rad = -steepest_approach_rad / half_pi * atanf(distance);
    // how the field turns as the aircraft flies through it
    const float slope_per_m = -1.0F / (width_m * (1.0F + distance * distance));
    const float field_rad_s = slope_per_m * speed_m_s * sinf(off_rad) + target->curvature_per_m * speed_m_s;
    const float error_rad = angle_to_rad(angle_wrap_180(angle_to_deg(approach_rad - off_rad)));
    const float turn_rad_s = gains->k_course_per_s * error_rad + field_rad_s;
    const float wanted_deg = angle_to_deg(atanf(turn_rad_s * speed_m_s / GRAVITY_M_S2));
    return limit_to(wanted_deg, -gains->bank_limit_deg, gains->bank_limit_deg);
}

float line_follow_update(line_follow_state_t* state, const line_follow_gains_t* gains,
                         const line_follow_target_t* target, const line_follow_input_t* input, float dt_s)
{
    const float step_deg = roll_rate_limit_deg_s * dt_s;
    const float wanted_deg = bank_deg(gains, target, input);
    state->roll_d_deg = limit_to(wanted_deg, state->roll_d_deg - step_deg, state->roll_d_deg + step_deg);
    const float error_deg = state->roll_d_deg - input->roll_deg;
    const float proportional = gains->k_bank * angle_to_rad(error_deg);
    if (!input->frozen && fabsf(error_deg) < integral_window_deg)
    {
        state->aileron_integral = limit_to(state->aileron_integral + gains->k_int_bank_per_s * proportional * dt_s,
                                           -integral_limit, integral_limit);
    }
    return limit_to(proportional + state->aileron_integral, -aileron_limit, aileron_limit);
}
