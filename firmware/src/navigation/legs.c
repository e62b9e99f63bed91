#include "navigation/legs.h"

#include <math.h>

#include "common/angle.h"
#include "common/units.h"
#include "navigation/turn.h"

static const float captured_radii = 1.2F;
static const float captured_ft = 100.0F;
static const float left_behind_radii = 0.5F; ///< so much further than at its nearest: the waypoint is passed
static const float opposite = 0.1F;          ///< length of the sum of two courses below which they have no bisector
static const float airspeed_smoothing_s = 4.0F;
static const float hold_radii = 1.2F; ///< the circle is wider than the tightest one, to have bank in hand

void legs_init(legs_t* legs)
{
    *legs = (legs_t){.has_leg = false};
    wind_init(&legs->wind);
}

void legs_restart(legs_t* legs)
{
    legs->has_leg = false;
    legs->is_passing = false;
    legs->wind.has_anchor = false;
}

static void begin_leg(legs_t* legs, const plan_t* plan, const position_t* from, float track_deg)
{
    legs->leg = leg_between(from, &plan->waypoints[plan->current].position, track_deg);
    legs->waypoint = plan->current;
    legs->changes = plan->changes;
    legs->has_leg = true;
}

static void end_passage(legs_t* legs)
{
    legs_passage_t* const passage = &legs->passage;
    passage->is_captured = passage->distance_m <= passage->within_m && fabsf(passage->altitude_error_ft) <= captured_ft;
    legs->captured += passage->is_captured ? 1U : 0U;
    legs->missed += passage->is_captured ? 0U : 1U;
    legs->is_passing = false;
}

/// Note how near the waypoint before is; it is passed beyond the bisector of the legs, or once it is left behind.
static void watch_passage(legs_t* legs, const legs_input_t* input)
{
    legs_passage_t* const passage = &legs->passage;
    const offset_t beyond = leg_offset_m(&legs->left.position, &input->position);
    const float distance_m = hypotf(beyond.north_m, beyond.east_m);
    if (distance_m < passage->distance_m)
    {
        passage->distance_m = distance_m;
        passage->altitude_error_ft = input->altitude_ft - legs->left.altitude_ft;
    }
    const bool is_beyond = beyond.north_m * legs->bisector_north + beyond.east_m * legs->bisector_east >= 0.0F;
    const float left_behind_m = passage->distance_m + left_behind_radii * passage->within_m;
    if (is_beyond || distance_m > left_behind_m)
    {
        end_passage(legs);
    }
}

static void begin_passage(legs_t* legs, const waypoint_t* left, float radius_m)
{
    if (legs->is_passing)
    {
        end_passage(legs);
    }
    legs->left = *left;
    legs->passage = (legs_passage_t){
        .waypoint = legs->waypoint,
        .distance_m = INFINITY,
        .within_m = captured_radii * radius_m,
    };
    legs->is_passing = true;
}

static void set_bisector(legs_t* legs, const leg_t* before, const leg_t* after)
{
    legs->bisector_north = before->north + after->north;
    legs->bisector_east = before->east + after->east;
    if (hypotf(legs->bisector_north, legs->bisector_east) < opposite)
    {
        legs->bisector_north = before->north;
        legs->bisector_east = before->east;
    }
}

static const waypoint_t* waypoint_after(const plan_t* plan)
{
    if (plan->current + 1 < plan->count)
    {
        return &plan->waypoints[plan->current + 1];
    }
    return plan->loop ? &plan->waypoints[0] : NULL;
}

/// Go on to the next leg where the turn onto it begins, or over the last waypoint to the circle around it.
static void sequence(legs_t* legs, plan_t* plan, const legs_input_t* input)
{
    const waypoint_t* const waypoint = &plan->waypoints[plan->current];
    const waypoint_t* const next = waypoint_after(plan);
    const leg_t before = legs->leg;
    const float remaining_m = leg_place(&before, &input->position).remaining_m;
    const leg_t after = next != NULL ? leg_between(&waypoint->position, &next->position, before.course_deg) : before;
    turn_t turn = turn_between(before.course_deg, after.course_deg, &legs->wind, legs->airspeed_m_s, input->bank_deg,
                               input->roll_time_s);
    const float longest_m = fminf(before.length_m, after.length_m) / 2.0F;
    if (next == NULL)
    {
        turn.lead_m = 0.0F;
    }
    if (!legs->is_passing)
    {
        legs->is_sharp = turn.is_sharp;
        legs->is_short = turn.lead_m > longest_m;
    }
    if (remaining_m > fminf(turn.lead_m, longest_m))
    {
        return;
    }
    begin_passage(legs, waypoint, turn.radius_m);
    set_bisector(legs, &before, &after);
    if (plan_next(plan))
    {
        begin_leg(legs, plan, &waypoint->position, before.course_deg);
    }
    else
    {
        plan_hold(plan);
    }
}

static void circle(const legs_t* legs, const plan_t* plan, const legs_input_t* input, legs_guidance_t* guidance)
{
    const position_t* const centre = &plan->waypoints[plan->current].position;
    const float fastest_m_s = input->airspeed_m_s + hypotf(legs->wind.north_m_s, legs->wind.east_m_s);
    const float tightest_m = fastest_m_s * fastest_m_s / (GRAVITY_M_S2 * tanf(angle_to_rad(input->bank_deg)));
    const float radius_m = fmaxf(plan_capture_radius_m(guidance->speed_kt), hold_radii * tightest_m);
    const offset_t from_centre = leg_offset_m(centre, &input->position);
    const float outwards_deg = angle_to_deg(atan2f(from_centre.east_m, from_centre.north_m));
    guidance->course_deg = angle_wrap_360(outwards_deg + 90.0F);
    guidance->right_m = radius_m - hypotf(from_centre.north_m, from_centre.east_m);
    guidance->curvature_per_m = 1.0F / radius_m;
}

static void smooth_airspeed(legs_t* legs, float airspeed_m_s, float dt_s)
{
    const float taken = legs->airspeed_m_s > 0.0F ? dt_s / (airspeed_smoothing_s + dt_s) : 1.0F;
    legs->airspeed_m_s += taken * (airspeed_m_s - legs->airspeed_m_s);
}

bool legs_update(legs_t* legs, plan_t* plan, const legs_input_t* input, float dt_s, legs_guidance_t* guidance)
{
    *guidance = (legs_guidance_t){0};
    wind_update(&legs->wind, &input->position, input->airspeed_m_s, dt_s);
    smooth_airspeed(legs, input->airspeed_m_s, dt_s);
    if (plan->count == 0 || !position_is_valid(&input->position))
    {
        return false;
    }
    if (!legs->has_leg || legs->changes != plan->changes || legs->waypoint != plan->current)
    {
        legs->is_passing = false;
        begin_leg(legs, plan, &input->position, input->track_deg);
    }
    if (!plan->holding)
    {
        sequence(legs, plan, input);
    }
    if (legs->is_passing)
    {
        watch_passage(legs, input);
    }
    // the turn is flown at the height of its waypoint, so that it is captured
    const waypoint_t* const target = legs->is_passing ? &legs->left : &plan->waypoints[plan->current];
    guidance->altitude_ft = target->altitude_ft;
    guidance->speed_kt = target->speed_kt;
    if (plan->holding)
    {
        circle(legs, plan, input, guidance);
        return true;
    }
    guidance->course_deg = legs->leg.course_deg;
    guidance->right_m = leg_place(&legs->leg, &input->position).right_m;
    return true;
}
