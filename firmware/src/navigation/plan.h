/// A list of waypoints, the one that the aircraft flies to, and the course to it.
#ifndef NAVIGATION_PLAN_H
#define NAVIGATION_PLAN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "navigation/geodesy.h"

enum
{
    plan_waypoints_max = 100
};

typedef struct
{
    position_t position;
    float altitude_ft; ///< above mean sea level
    float speed_kt;    ///< indicated airspeed on the way to this waypoint
} waypoint_t;

typedef struct
{
    waypoint_t waypoints[plan_waypoints_max];
    size_t count;
    size_t current;   ///< index from 0 of the waypoint flown to
    bool loop;        ///< after the last waypoint the first one follows; else the last one is circled
    bool holding;     ///< the last waypoint was reached and is being circled
    uint32_t changes; ///< counts new plans and new waypoints to fly to
} plan_t;

/// What the plan asks for at a position.
typedef struct
{
    float bearing_deg; ///< to the waypoint, 0..360
    float course_deg;  ///< track to fly, 0..360: the bearing, or the tangent while circling
    float altitude_ft;
    float speed_kt;
    float distance_m; ///< to the waypoint
    size_t waypoint;
} plan_guidance_t;

/// No waypoints.
void plan_clear(plan_t* plan);

/// True when position, altitude and speed are finite and can be flown
/// (-2000..60000 ft, 0..500 kt).
bool waypoint_is_valid(const waypoint_t* waypoint);

/// Replace the plan and begin at its first waypoint. False, and nothing changed, when `count` is not 1..100 or a
/// waypoint is not valid.
bool plan_replace(plan_t* plan, const waypoint_t* waypoints, size_t count, bool loop);

/// Circle the last waypoint from now on.
void plan_hold(plan_t* plan);

/// Fly to another waypoint; false, and nothing changed, when there is none. In a loop the first one follows the last.
bool plan_next(plan_t* plan);
bool plan_previous(plan_t* plan);
bool plan_go_to(plan_t* plan, int32_t index);

/// Distance in m at which a waypoint counts as reached: 200 up to 55 kt, above that 1.5 V^2 / (g tan 30 deg), but at
/// least 200. At 55 kt the two differ by a few metres only.
float plan_capture_radius_m(float speed_kt);

/// Continue with the next waypoint when this one is reached, and give the guidance from `position` at `speed_kt`.
/// False, and `guidance` all 0, when the plan is empty or the position not valid.
bool plan_update(plan_t* plan, const position_t* position, float speed_kt, plan_guidance_t* guidance);

/// The same without changing the plan, for reports.
bool plan_guidance(const plan_t* plan, const position_t* position, float speed_kt, plan_guidance_t* guidance);

#endif
