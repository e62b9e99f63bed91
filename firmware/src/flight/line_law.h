/// The line law: holds the legs of a plan as lines over the ground, and altitude and speed by total energy.
#ifndef FLIGHT_LINE_LAW_H
#define FLIGHT_LINE_LAW_H

#include <stdbool.h>

#include "control/autopilot.h"
#include "control/energy.h"
#include "control/line_follow.h"
#include "flight/line_gains.h"
#include "navigation/legs.h"

typedef struct
{
    legs_t legs;
    line_follow_state_t follow;
    energy_state_t energy;
    line_follow_target_t target; ///< the line that is held
    bool is_slow;                ///< over the ground: flown faster than planned, against the wind
    float ground_speed_m_s;      ///< along the track, at the newest command
} line_law_t;

typedef struct
{
    position_t position;
    autopilot_input_t state;
    float rate_per_command_rad_s; ///< pitch rate that a full elevator command asks for
} line_law_input_t;

/// No leg, no wind known.
void line_law_init(line_law_t* law);

/// Begin from the present attitude and throttle, with a leg from where the aircraft is.
void line_law_engage(line_law_t* law, const line_law_input_t* input, float throttle);

/// Sequence `plan` by `dt_s` (>= 0) and put what it asks for into `hold`. Without a plan or a position, the course,
/// altitude and speed in `hold` are what is held.
void line_law_navigate(line_law_t* law, const line_gains_t* gains, plan_t* plan, const line_law_input_t* input,
                       autopilot_target_t* hold, float dt_s);

/// One step towards what `line_law_navigate` found.
control_command_t line_law_command(line_law_t* law, const line_gains_t* gains, const autopilot_target_t* hold,
                                   const line_law_input_t* input, float dt_s);

#endif
