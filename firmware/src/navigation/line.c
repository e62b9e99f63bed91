#include "navigation/line.h"

#include <math.h>

#include "common/angle.h"
#include "common/units.h"
#include "navigation/turn.h"

static const float captured_radii = 1.2F;
static const float captured_ft = 100.0F;
static const float left_behind_radii = 0.5F; ///< so much further than at its nearest: the waypoint is passed
static const float opposite = 0.1F;          ///< length of the sum of two courses below which they have no bisector
static const float hold_radii = 1.2F;        ///< the circle is wider than the tightest one, to have bank in hand

void line_init(line_t* line)
{
    *line = (line_t){.has_leg = false};
    wind_init(&line->wind);
}

void line_restart(line_t* line)
{
    line->has_leg = false;
    line->is_passing = false;
    line->wind.has_anchor = false;
}

static void begin_leg(line_t* line, const plan_t* plan, const position_t* from, float track_deg)
{
    line->leg = leg_between(from, &plan->waypoints[plan->current].position, track_deg);
    line->waypoint = plan->current;
    line->changes = plan->changes;
    line->has_leg = true;
}

static void end_passage(line_t* line)
{
    line_passage_t* const passage = &line->passage;
    passage->is_captured =
        passage->distance_m <= passage->within_m && fabsf(passage->altitude_error_ft) <= captured_ft;
    line->captured += passage->is_captured ? 1U : 0U;
    line->missed += passage->is_captured ? 0U : 1U;
    line->is_passing = false;
}

/// Note how near the waypoint before is; it is passed beyond the bisector of the legs, or once it is left behind.
static void watch_passage(line_t* line, const line_input_t* input)
{
    line_passage_t* const passage = &line->passage;
    const offset_t beyond = leg_offset_m(&line->left.position, &input->position);
    const float distance_m = hypotf(beyond.north_m, beyond.east_m);
    if (distance_m < passage->distance_m)
    {
        passage->distance_m = distance_m;
        passage->altitude_error_ft = input->altitude_ft - line->left.altitude_ft;
    }
    const bool is_beyond = beyond.north_m * line->bisector_north + beyond.east_m * line->bisector_east >= 0.0F;
    const float left_behind_m = passage->distance_m + left_behind_radii * passage->within_m;
    if (is_beyond || distance_m > left_behind_m)
    {
        end_passage(line);
    }
}

static void begin_passage(line_t* line, const waypoint_t* left, float radius_m)
{
    if (line->is_passing)
    {
        end_passage(line);
    }
    line->left = *left;
    line->passage = (line_passage_t){
        .waypoint = line->waypoint,
        .distance_m = INFINITY,
        .within_m = captured_radii * radius_m,
    };
    line->is_passing = true;
}

static void set_bisector(line_t* line, const leg_t* before, const leg_t* after)
{
    line->bisector_north = before->north + after->north;
    line->bisector_east = before->east + after->east;
    if (hypotf(line->bisector_north, line->bisector_east) < opposite)
    {
        line->bisector_north = before->north;
        line->bisector_east = before->east;
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
static void sequence(line_t* line, plan_t* plan, const line_input_t* input)
{
    const waypoint_t* const waypoint = &plan->waypoints[plan->current];
    const waypoint_t* const next = waypoint_after(plan);
    const leg_t before = line->leg;
    const float remaining_m = leg_place(&before, &input->position).remaining_m;
    const leg_t after =
        next != NULL ? leg_between(&waypoint->position, &next->position, before.course_deg) : before;
    turn_t turn = turn_between(before.course_deg, after.course_deg, &line->wind, input->airspeed_m_s, input->bank_deg,
                               input->roll_time_s);
    const float longest_m = fminf(before.length_m, after.length_m) / 2.0F;
    if (next == NULL)
    {
        turn.lead_m = 0.0F;
    }
    if (!line->is_passing)
    {
        line->is_sharp = turn.is_sharp;
        line->is_short = turn.lead_m > longest_m;
    }
    if (remaining_m > fminf(turn.lead_m, longest_m))
    {
        return;
    }
    begin_passage(line, waypoint, turn.radius_m);
    set_bisector(line, &before, &after);
    if (plan_next(plan))
    {
        begin_leg(line, plan, &waypoint->position, before.course_deg);
    }
    else
    {
        plan_hold(plan);
    }
}

static void circle(const line_t* line, const plan_t* plan, const line_input_t* input, line_guidance_t* guidance)
{
    const position_t* const centre = &plan->waypoints[plan->current].position;
    const float fastest_m_s = input->airspeed_m_s + hypotf(line->wind.north_m_s, line->wind.east_m_s);
    const float tightest_m = fastest_m_s * fastest_m_s / (GRAVITY_M_S2 * tanf(angle_to_rad(input->bank_deg)));
    const float radius_m = fmaxf(plan_capture_radius_m(guidance->speed_kt), hold_radii * tightest_m);
    const offset_t from_centre = leg_offset_m(centre, &input->position);
    const float outwards_deg = angle_to_deg(atan2f(from_centre.east_m, from_centre.north_m));
    guidance->course_deg = angle_wrap_360(outwards_deg + 90.0F);
    guidance->right_m = radius_m - hypotf(from_centre.north_m, from_centre.east_m);
    guidance->curvature_per_m = 1.0F / radius_m;
}

bool line_update(line_t* line, plan_t* plan, const line_input_t* input, float dt_s, line_guidance_t* guidance)
{
    *guidance = (line_guidance_t){0};
    wind_update(&line->wind, &input->position, input->airspeed_m_s, dt_s);
    if (plan->count == 0 || !position_is_valid(&input->position))
    {
        return false;
    }
    if (!line->has_leg || line->changes != plan->changes || line->waypoint != plan->current)
    {
        line->is_passing = false;
        begin_leg(line, plan, &input->position, input->track_deg);
    }
    if (!plan->holding)
    {
        sequence(line, plan, input);
    }
    if (line->is_passing)
    {
        watch_passage(line, input);
    }
    // the turn is flown at the height of its waypoint, so that it is captured
    const waypoint_t* const target = line->is_passing ? &line->left : &plan->waypoints[plan->current];
    guidance->altitude_ft = target->altitude_ft;
    guidance->speed_kt = target->speed_kt;
    if (plan->holding)
    {
        circle(line, plan, input, guidance);
        return true;
    }
    guidance->course_deg = line->leg.course_deg;
    guidance->right_m = leg_place(&line->leg, &input->position).right_m;
    return true;
}
