/// One aircraft under control: plan, autopilot, fly-by-wire and bumpless change between them. The board has two, the
/// real aircraft and the one in the simulator, and both run this very code.
#ifndef FLIGHT_CONTROL_LOOP_H
#define FLIGHT_CONTROL_LOOP_H

#include <stdbool.h>
#include <stdint.h>

#include "control/autopilot.h"
#include "control/fly_by_wire.h"
#include "control/transition.h"
#include "navigation/plan.h"
#include "navigation/track.h"

/// Whose stick the simulated aircraft obeys, with the numbers of the wire.
typedef enum
{
    control_source_rc = 0,
    control_source_joystick = 1
} control_source_t;

typedef struct
{
    fly_by_wire_gains_t fly_by_wire;
    autopilot_gains_t autopilot;
} control_loop_gains_t;

/// What is known of the aircraft and what its pilot wants. Signs as in `fly_by_wire.h` and `autopilot.h`.
typedef struct
{
    surfaces_t stick; ///< -1..+1, throttle 0..1
    float p_rad_s;
    float q_rad_s;
    float r_rad_s;
    float direction_deg; ///< ground track, or true heading where the source has no track
    float pitch_deg;
    float roll_deg;
    float altitude_ft;
    float vvi_ft_min;
    float speed_kt;
    position_t position;
    int32_t source; ///< whose stick it is; any change of the number is made bumpless
    bool autopilot;
    bool autotrim;
} control_loop_input_t;

typedef struct
{
    fly_by_wire_state_t fly_by_wire;
    autopilot_state_t autopilot;
    transition_t transition;
    track_t track;
    autopilot_target_t hold;  ///< what the autopilot flies; without a plan, the moment it was switched on
    float ground_altitude_ft; ///< where the aircraft last was below flying speed
    float ground_run_s;       ///< time on the ground at flying speed
    bool ground_is_known;
    int32_t source; ///< these three: of the last step
    bool autopilot_was_on;
    bool autotrim_was_on;
    bool has_run;
    surfaces_t surfaces; ///< newest output
} control_loop_t;

void control_loop_init(control_loop_t* loop);

/// Fly by no law: these surfaces, inside of their limits. The next step begins where they are, whoever commands then.
void control_loop_override(control_loop_t* loop, const surfaces_t* surfaces);

/// One step of `dt_s` (>= 0; 0 after a pause, when nothing may be integrated). Sequences `plan` too. Returns the new
/// surfaces, which are finite and inside of their limits whatever the input.
surfaces_t control_loop_step(control_loop_t* loop, const control_loop_gains_t* gains, plan_t* plan,
                             const control_loop_input_t* input, float dt_s);

#endif
