/// The law between stick or autopilot and the surfaces: damping of the rates, less at higher speed, and elevator trim.
///
/// Signs: elevator + nose up, aileron + right wing down, rudder + nose right; P, Q, R body rates in rad/s with the
/// same signs; throttle 0..1. Source: the specification of the control laws, "Fly-by-wire".
#ifndef CONTROL_FLY_BY_WIRE_H
#define CONTROL_FLY_BY_WIRE_H

#include <stdbool.h>

#include "control/surfaces.h"

typedef struct
{
    float k_elev;            ///< surface per elevator error
    float k_int_pitch_per_s; ///< trim per elevator error and second
    float k_airln;           ///< surface per aileron error
    float k_rudder;          ///< surface per rudder error
    float k_div_p_init;      ///< rad/s of roll per unit command, standing
    float k_div_p_speed_kt;  ///< speed at which one rad/s is added to it
    float k_div_q_init;
    float k_div_q_speed_kt;
    float k_div_r_init;
    float k_div_r_speed_kt;
} fly_by_wire_gains_t;

typedef struct
{
    float trim; ///< int_elev: the elevator that the automatic trim holds, -1..+1
} fly_by_wire_state_t;

/// The wanted motion, from the pilot (`fly_by_wire_command_of_stick`) or by the autopilot.
typedef struct
{
    float elevator;
    float aileron;
    float rudder;
    float throttle; ///< 0..1
} control_command_t;

typedef struct
{
    float p_rad_s;
    float q_rad_s;
    float r_rad_s;
    float speed_kt; ///< indicated airspeed
    bool autotrim;  ///< off: the trim is 0
    bool frozen;    ///< below 20 kt or on the ground: the trim keeps its value
} fly_by_wire_input_t;

/// A stick (-1..+1, throttle 0..1) as command: elevator twofold, aileron threefold, the rest straight through.
control_command_t fly_by_wire_command_of_stick(float elevator, float aileron, float rudder, float throttle);

/// Pitch rate that a full elevator command asks for at this indicated airspeed.
float fly_by_wire_pitch_rate_rad_s(const fly_by_wire_gains_t* gains, float speed_kt);

/// One step of `dt_s` (>= 0).
surfaces_t fly_by_wire_update(fly_by_wire_state_t* state, const fly_by_wire_gains_t* gains,
                              const control_command_t* command, const fly_by_wire_input_t* input, float dt_s);

/// Set the trim so that the next step with `command` and `input` gives `elevator`, as far as the trim's limit allows.
void fly_by_wire_hold_elevator(fly_by_wire_state_t* state, const fly_by_wire_gains_t* gains,
                               const control_command_t* command, const fly_by_wire_input_t* input, float elevator);

#endif
