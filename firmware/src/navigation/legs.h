/// The legs of a plan as lines to be held: which leg is flown, where its turn begins, and what was captured.
///
/// A leg begins where the one before ended; after a new plan or a command to fly to a waypoint, where the aircraft is
/// then. The turn onto the next leg begins early enough to end on it (`turn.h`). The waypoint in between counts as
/// captured if the aircraft then passes near it, in height too; otherwise as missed. The last waypoint is flown over
/// and then circled clockwise, unless the plan is a loop.
#ifndef NAVIGATION_LEGS_H
#define NAVIGATION_LEGS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "navigation/leg.h"
#include "navigation/plan.h"
#include "navigation/wind.h"

/// How a waypoint was passed.
typedef struct
{
    size_t waypoint;
    float distance_m;        ///< at its nearest
    float altitude_error_ft; ///< then; too high is positive
    float within_m;          ///< how near it had to be: 1.2 radii of the turn
    bool is_captured;        ///< within that, and within 100 ft
} legs_passage_t;

typedef struct
{
    wind_t wind;
    float airspeed_m_s; ///< smoothed: a gust must not begin a turn
    leg_t leg;          ///< that is flown
    bool has_leg;
    size_t waypoint;      ///< that the leg ends at
    uint32_t changes;     ///< of the plan when the leg began
    bool is_passing;      ///< the waypoint before is not passed yet
    waypoint_t left;      ///< the waypoint before
    float bisector_north; ///< between the two legs' courses
    float bisector_east;
    legs_passage_t passage; ///< newest, or the one under way
    uint32_t captured;      ///< waypoints since the start
    uint32_t missed;
    bool is_sharp; ///< the turn that comes or is flown: too sharp for its bank, the aircraft comes back onto the leg
    bool is_short; ///< the leg is too short for its turns: they begin at its middle
} legs_t;

typedef struct
{
    position_t position;
    float track_deg;
    float airspeed_m_s; ///< true
    float altitude_ft;
    float bank_deg;    ///< of the turns
    float roll_time_s; ///< lag of the bank
} legs_input_t;

/// What the plan asks for.
typedef struct
{
    float course_deg;      ///< of the line at the nearest point
    float right_m;         ///< from the line, + right of it
    float curvature_per_m; ///< of the line, + to the right
    float altitude_ft;
    float speed_kt;
} legs_guidance_t;

/// No leg, no wind known.
void legs_init(legs_t* legs);

/// Begin the next leg anew, where the aircraft is then; the wind stays known.
void legs_restart(legs_t* legs);

/// Go on by `dt_s` (>= 0), sequencing `plan`. False, and nothing asked for, when the plan is empty or the position is
/// not valid.
bool legs_update(legs_t* legs, plan_t* plan, const legs_input_t* input, float dt_s, legs_guidance_t* guidance);

#endif
