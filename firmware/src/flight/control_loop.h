/// One aircraft under control: plan, autopilot, fly-by-wire and bumpless change between them. The board controls
/// two, the real aircraft and the simulated one, both with this code.
#ifndef FLIGHT_CONTROL_LOOP_H
#define FLIGHT_CONTROL_LOOP_H

#include <stdbool.h>
#include <stdint.h>

#include "control/autopilot.h"
#include "control/fly_by_wire.h"
#include "control/transition.h"
#include "flight/line_law.h"
#include "navigation/plan.h"
#include "navigation/track.h"

/// Whose stick the simulated aircraft obeys, with the numbers of the wire.
typedef enum
{
    control_source_rc = 0,
    control_source_joystick = 1
} control_source_t;

/// How the autopilot flies a plan.
typedef enum
{
    guidance_law_bearing = 0, ///< towards the next waypoint, as deployed boards do
    guidance_law_line = 1     ///< along the line to it
} guidance_law_t;

typedef struct
{
    fly_by_wire_gains_t fly_by_wire;
    autopilot_gains_t autopilot;
    line_gains_t line;
    guidance_law_t law;
} control_loop_gains_t;

/// State of the aircraft, and what its pilot commands. Signs as in `fly_by_wire.h` and `autopilot.h`.
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
    int32_t source; ///< whose stick it is; a change of this number is made bumpless
    bool autopilot;
    bool autotrim;
} control_loop_input_t;

typedef struct
{
    fly_by_wire_state_t fly_by_wire;
    autopilot_state_t autopilot;
    line_law_t line;
    transition_t transition;
    track_t track;
    autopilot_target_t hold;  ///< the autopilot's target; without a plan, the state when it was switched on
    float ground_altitude_ft; ///< where the aircraft last was below flying speed
    float ground_run_s;       ///< time on the ground at flying speed
    bool ground_is_known;
    int32_t source; ///< these four: of the last step
    guidance_law_t law;
    bool autopilot_was_on;
    bool autotrim_was_on;
    bool has_run;
    surfaces_t surfaces; ///< newest output
} control_loop_t;

/// Indicated airspeed below which every integral is frozen.
extern const float control_loop_flying_speed_kt;

void control_loop_init(control_loop_t* loop);

/// Set the surfaces directly, inside of their limits. The next step begins from them without a jump.
void control_loop_override(control_loop_t* loop, const surfaces_t* surfaces);

/// One step of `dt_s` (>= 0; 0 during and after a pause, when nothing may be integrated or averaged). Sequences `plan`
/// too. Returns the new surfaces, which are finite and inside of their limits whatever the input.
surfaces_t control_loop_step(control_loop_t* loop, const control_loop_gains_t* gains, plan_t* plan,
                             const control_loop_input_t* input, float dt_s);

#endif
