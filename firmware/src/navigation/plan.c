#include "navigation/plan.h"

#include <math.h>
#include <string.h>

#include "common/angle.h"
#include "common/units.h"

static const float capture_minimum_m = 200.0F;
static const float capture_minimum_to_kt = 55.0F;
static const float capture_turns = 1.5F; ///< a waypoint counts as reached at this many radii of the steepest turn
static const float tan_30_deg = 0.57735F;

// How strongly the course turns towards the circle while holding. With 2, the aircraft settles a fifth outside of the
// radius, where the bank that the heading law commands is the one that the circle needs.
static const float hold_gain = 2.0F;

static const float altitude_minimum_ft = -2000.0F;
static const float altitude_maximum_ft = 60000.0F;
static const float speed_maximum_kt = 500.0F;

void plan_clear(plan_t* plan)
{
    memset(plan, 0, sizeof *plan);
}

bool waypoint_is_valid(const waypoint_t* waypoint)
{
    // written so that a NaN fails
    return position_is_valid(&waypoint->position) && waypoint->altitude_ft >= altitude_minimum_ft &&
           waypoint->altitude_ft <= altitude_maximum_ft && waypoint->speed_kt >= 0.0F &&
           waypoint->speed_kt <= speed_maximum_kt;
}

bool plan_replace(plan_t* plan, const waypoint_t* waypoints, size_t count, bool loop)
{
    if (count < 1 || count > plan_waypoints_max)
    {
        return false;
    }
    for (size_t i = 0; i < count; i++)
    {
        if (!waypoint_is_valid(&waypoints[i]))
        {
            return false;
        }
    }
    memcpy(plan->waypoints, waypoints, count * sizeof *waypoints);
    plan->count = count;
    plan->current = 0;
    plan->loop = loop;
    plan->holding = false;
    plan->changes++;
    return true;
}

static void fly_to(plan_t* plan, size_t index)
{
    plan->current = index;
    plan->holding = false;
    plan->changes++;
}

void plan_hold(plan_t* plan)
{
    plan->holding = true;
}

bool plan_next(plan_t* plan)
{
    if (plan->current + 1 < plan->count)
    {
        fly_to(plan, plan->current + 1);
        return true;
    }
    if (plan->loop && plan->count > 0)
    {
        fly_to(plan, 0);
        return true;
    }
    return false;
}

bool plan_previous(plan_t* plan)
{
    if (plan->current > 0)
    {
        fly_to(plan, plan->current - 1);
        return true;
    }
    if (plan->loop && plan->count > 0)
    {
        fly_to(plan, plan->count - 1);
        return true;
    }
    return false;
}

bool plan_go_to(plan_t* plan, int32_t index)
{
    if (index < 0 || (size_t)index >= plan->count)
    {
        return false;
    }
    fly_to(plan, (size_t)index);
    return true;
}

float plan_capture_radius_m(float speed_kt)
{
    if (!(speed_kt > capture_minimum_to_kt))
    {
        return capture_minimum_m;
    }
    const float speed_m_s = speed_kt * M_S_PER_KT;
    return fmaxf(capture_minimum_m, capture_turns * speed_m_s * speed_m_s / (GRAVITY_M_S2 * tan_30_deg));
}

/// Track that leads onto a clockwise circle around the waypoint: straight to it from far away, along the tangent on
/// the circle, outwards from inside.
static float hold_course_deg(float bearing_deg, float distance_m, float radius_m)
{
    const float inwards_deg = angle_to_deg(atanf(hold_gain * (distance_m - radius_m) / radius_m));
    return angle_wrap_360(bearing_deg - 90.0F + inwards_deg);
}

bool plan_guidance(const plan_t* plan, const position_t* position, float speed_kt, plan_guidance_t* guidance)
{
    *guidance = (plan_guidance_t){0};
    if (plan->count == 0 || !position_is_valid(position))
    {
        return false;
    }
    const waypoint_t* const waypoint = &plan->waypoints[plan->current];
    guidance->bearing_deg = geodesy_bearing_deg(position, &waypoint->position);
    guidance->distance_m = geodesy_distance_m(position, &waypoint->position);
    guidance->course_deg = guidance->bearing_deg;
    guidance->altitude_ft = waypoint->altitude_ft;
    guidance->speed_kt = waypoint->speed_kt;
    guidance->waypoint = plan->current;
    if (plan->holding)
    {
        guidance->course_deg =
            hold_course_deg(guidance->bearing_deg, guidance->distance_m, plan_capture_radius_m(speed_kt));
    }
    return true;
}

bool plan_update(plan_t* plan, const position_t* position, float speed_kt, plan_guidance_t* guidance)
{
    if (!plan_guidance(plan, position, speed_kt, guidance))
    {
        return false;
    }
    if (plan->holding || guidance->distance_m >= plan_capture_radius_m(speed_kt))
    {
        return true;
    }
    if (!plan_next(plan))
    {
        plan_hold(plan);
    }
    return plan_guidance(plan, position, speed_kt, guidance);
}
