/// Upload of a plan: collected beside the plans in use, and taken over completely or not at all.
#ifndef NAVIGATION_MISSION_H
#define NAVIGATION_MISSION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "navigation/plan.h"

typedef struct
{
    waypoint_t waypoints[plan_waypoints_max];
    bool received[plan_waypoints_max];
    size_t count; ///< announced waypoints; 0: no upload under way
    int32_t plan; ///< which plan it is for
} mission_t;

typedef enum
{
    mission_ok,
    mission_bad_value, ///< index, count or waypoint outside of its range
    mission_bad_state  ///< no upload of that plan under way, or waypoints are missing
} mission_status_t;

/// No upload under way.
void mission_init(mission_t* mission);

/// Begin an upload of `count` (1..100) waypoints; an unfinished one is dropped.
mission_status_t mission_begin(mission_t* mission, int32_t plan, int32_t count);

/// Stage one waypoint; sending one again overwrites it.
mission_status_t mission_item(mission_t* mission, int32_t plan, int32_t index, const waypoint_t* waypoint);

/// Replace `target` by the staged waypoints, only when all are there; ends the upload then.
mission_status_t mission_commit(mission_t* mission, int32_t plan, plan_t* target);

#endif
