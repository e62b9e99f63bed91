#include "control/fly_by_wire.h"

#include "common/limit.h"

// sensitivity of the stick in assisted flight
static const float elevator_per_stick = 2.0F;
static const float aileron_per_stick = 3.0F;

/// Rate in rad/s that a full command asks for. It grows with the speed, as the surfaces become more effective.
static float rate_scale(float init, float speed_scale_kt, float speed_kt)
{
    const float ratio = speed_kt / speed_scale_kt;
    return init + ratio * ratio;
}

float fly_by_wire_pitch_rate_rad_s(const fly_by_wire_gains_t* gains, float speed_kt)
{
    return rate_scale(gains->k_div_q_init, gains->k_div_q_speed_kt, speed_kt);
}

static float elevator_error(const fly_by_wire_gains_t* gains, const control_command_t* command,
                            const fly_by_wire_input_t* input)
{
    return command->elevator - input->q_rad_s / fly_by_wire_pitch_rate_rad_s(gains, input->speed_kt);
}

control_command_t fly_by_wire_command_of_stick(float elevator, float aileron, float rudder, float throttle)
{
    return (control_command_t){
        .elevator = elevator_per_stick * elevator,
        .aileron = aileron_per_stick * aileron,
        .rudder = rudder,
        .throttle = throttle,
    };
}

surfaces_t fly_by_wire_update(fly_by_wire_state_t* state, const fly_by_wire_gains_t* gains,
                              const control_command_t* command, const fly_by_wire_input_t* input, float dt_s)
{
    const float error_q = elevator_error(gains, command, input);
    if (!input->autotrim)
    {
        state->trim = 0.0F;
    }
    else if (!input->frozen)
    {
        state->trim = limit_to(state->trim + gains->k_int_pitch_per_s * error_q * dt_s, -1.0F, 1.0F);
    }
    const float div_p = rate_scale(gains->k_div_p_init, gains->k_div_p_speed_kt, input->speed_kt);
    const float div_r = rate_scale(gains->k_div_r_init, gains->k_div_r_speed_kt, input->speed_kt);
    return (surfaces_t){
        .elevator = limit_to(gains->k_elev * error_q + state->trim, -1.0F, 1.0F),
        .aileron = limit_to(gains->k_airln * (command->aileron - input->p_rad_s / div_p), -1.0F, 1.0F),
        .rudder = limit_to(gains->k_rudder * (command->rudder - input->r_rad_s / div_r), -1.0F, 1.0F),
        .throttle = limit_to(command->throttle, 0.0F, 1.0F),
    };
}

void fly_by_wire_hold_elevator(fly_by_wire_state_t* state, const fly_by_wire_gains_t* gains,
                               const control_command_t* command, const fly_by_wire_input_t* input, float elevator)
{
    state->trim = limit_to(elevator - gains->k_elev * elevator_error(gains, command, input), -1.0F, 1.0F);
}
