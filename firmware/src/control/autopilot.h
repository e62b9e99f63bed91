/// The autopilot: holds altitude, track and speed by giving the fly-by-wire the command that a pilot would give.
///
/// Source: the specification of the control laws, "Autopilot". Altitudes ft, climb ft/min up, angles deg (pitch up,
/// roll right, track clockwise from true north), speeds kt indicated.
#ifndef CONTROL_AUTOPILOT_H
#define CONTROL_AUTOPILOT_H

#include <stdbool.h>

#include "control/fly_by_wire.h"

typedef struct
{
    float k_altitude;           ///< k_altura: deg of pitch per ft
    float k_int_altitude_per_s; ///< k_int_altura: share of the proportional pitch that is added each second
    float k_vvi_ft_per_ft_min;  ///< k_VVI: ft of lead per ft/min
    float k_pitch;              ///< elevator command per rad of pitch error
    float k_heading;            ///< deg of roll per deg of track error
    float k_roll;               ///< aileron command per rad of roll error
    float k_div_speed_kt_s;     ///< k_div_velocidad: kt s of speed error for full throttle
} autopilot_gains_t;

typedef struct
{
    float altitude_integral_deg; ///< i_alt: pitch that holds the altitude, -10..+10
    float throttle;              ///< 0..1
} autopilot_state_t;

typedef struct
{
    float altitude_ft;
    float course_deg; ///< track to fly
    float speed_kt;
} autopilot_target_t;

typedef struct
{
    float altitude_ft;
    float vvi_ft_min;
    float track_deg; ///< over the ground
    float pitch_deg;
    float roll_deg;
    float speed_kt;
    bool frozen; ///< below 20 kt or on the ground: integrals keep their value
} autopilot_input_t;

/// Start the integrals from this moment: the throttle from what is set now, the pitch from the attitude that would
/// hold the altitude now (pitch less the climb angle).
void autopilot_engage(autopilot_state_t* state, const autopilot_input_t* input, float throttle);

/// One step of `dt_s` (>= 0).
control_command_t autopilot_update(autopilot_state_t* state, const autopilot_gains_t* gains,
                                   const autopilot_target_t* target, const autopilot_input_t* input, float dt_s);

#endif
