#include "control/autopilot.h"

#include <math.h>

#include "common/angle.h"
#include "common/limit.h"

static const float pitch_minimum_deg = -20.0F;
static const float pitch_maximum_deg = 15.0F;
static const float altitude_integral_limit_deg = 10.0F;
static const float altitude_integral_window_ft = 100.0F;
static const float elevator_limit = 0.1F;
static const float roll_limit_deg = 30.0F;
static const float aileron_limit = 0.7F;
static const float ft_min_per_kt = 101.2686F;

void autopilot_engage(autopilot_state_t* state, const autopilot_input_t* input, float throttle)
{
    const float along_ft_min = input->speed_kt * ft_min_per_kt;
    const float climb_deg = along_ft_min > 0.0F ? angle_to_deg(atan2f(input->vvi_ft_min, along_ft_min)) : 0.0F;
    state->altitude_integral_deg =
        limit_to(input->pitch_deg - climb_deg, -altitude_integral_limit_deg, altitude_integral_limit_deg);
    state->throttle = limit_to(throttle, 0.0F, 1.0F);
}

/// Elevator command that brings the aircraft to the altitude, with the climb as damping.
static float hold_altitude(autopilot_state_t* state, const autopilot_gains_t* gains, float target_ft,
                           const autopilot_input_t* input, float dt_s)
{
    const float error_ft = target_ft - (input->altitude_ft + gains->k_vvi_ft_per_ft_min * input->vvi_ft_min);
    const float wanted_deg = gains->k_altitude * error_ft + state->altitude_integral_deg;
    const float pitch_d_deg = limit_to(wanted_deg, pitch_minimum_deg, pitch_maximum_deg);
    const bool pushes_into_limit =
        (wanted_deg >= pitch_maximum_deg && error_ft > 0.0F) || (wanted_deg <= pitch_minimum_deg && error_ft < 0.0F);
    if (!input->frozen && !pushes_into_limit && fabsf(target_ft - input->altitude_ft) < altitude_integral_window_ft)
    {
        const float step_deg = gains->k_int_altitude_per_s * gains->k_altitude * error_ft * dt_s;
        state->altitude_integral_deg = limit_to(state->altitude_integral_deg + step_deg, -altitude_integral_limit_deg,
                                                altitude_integral_limit_deg);
    }
    return limit_to(gains->k_pitch * angle_to_rad(pitch_d_deg - input->pitch_deg), -elevator_limit, elevator_limit);
}

static float hold_course(const autopilot_gains_t* gains, float course_deg, const autopilot_input_t* input)
{
    const float error_deg = angle_wrap_180(course_deg - input->track_deg);
    const float roll_d_deg = limit_to(gains->k_heading * error_deg, -roll_limit_deg, roll_limit_deg);
    return limit_to(gains->k_roll * angle_to_rad(roll_d_deg - input->roll_deg), -aileron_limit, aileron_limit);
}

static float hold_speed(autopilot_state_t* state, const autopilot_gains_t* gains, float target_kt,
                        const autopilot_input_t* input, float dt_s)
{
    if (!input->frozen)
    {
        const float step = (target_kt - input->speed_kt) / gains->k_div_speed_kt_s * dt_s;
        state->throttle = limit_to(state->throttle + step, 0.0F, 1.0F);
    }
    return state->throttle;
}

control_command_t autopilot_update(autopilot_state_t* state, const autopilot_gains_t* gains,
                                   const autopilot_target_t* target, const autopilot_input_t* input, float dt_s)
{
    return (control_command_t){
        .elevator = hold_altitude(state, gains, target->altitude_ft, input, dt_s),
        .aileron = hold_course(gains, target->course_deg, input),
        .rudder = 0.0F,
        .throttle = hold_speed(state, gains, target->speed_kt, input, dt_s),
    };
}
