#include "support/cmocka_all.h"

#include <string.h>

#include "navigation/geodesy.h"
#include "navigation/plan.h"
#include "navigation/routes_gen.h"

// about 11 km apart, to the north
static const waypoint_t three[] = {
    {{28.0, -15.0}, 700.0F, 55.0F},
    {{28.1, -15.0}, 1000.0F, 60.0F},
    {{28.2, -15.0}, 800.0F, 50.0F},
};

static plan_t plan_of_three(bool loop)
{
    plan_t plan;
    plan_clear(&plan);
    assert_true(plan_replace(&plan, three, 3, loop));
    return plan;
}

static void an_empty_plan_gives_no_guidance(void** state)
{
    (void)state;
    plan_t plan;
    plan_clear(&plan);
    plan_guidance_t guidance = {.bearing_deg = 5.0F};
    assert_false(plan_update(&plan, &three[0].position, 55.0F, &guidance));
    assert_close(guidance.bearing_deg, 0.0, 0.0);
    assert_false(plan_next(&plan));
    assert_false(plan_previous(&plan));
    assert_false(plan_go_to(&plan, 0));
}

static void guidance_leads_to_the_waypoint_with_its_altitude_and_speed(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(false);
    const position_t south = {27.95, -15.0};
    plan_guidance_t guidance;
    assert_true(plan_update(&plan, &south, 55.0F, &guidance));
    assert_close(guidance.bearing_deg, 0.0, 1e-3);
    assert_close(guidance.course_deg, 0.0, 1e-3);
    assert_close(guidance.distance_m, 5559.75, 1.0);
    assert_close(guidance.altitude_ft, 700.0, 0.0);
    assert_close(guidance.speed_kt, 55.0, 0.0);
    assert_int_equal(guidance.waypoint, 0);
}

static void the_next_waypoint_comes_inside_of_the_capture_radius(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(false);
    plan_guidance_t guidance;
    const position_t outside = {28.0 - 201.0 / GEODESY_M_PER_DEG, -15.0};
    assert_true(plan_update(&plan, &outside, 50.0F, &guidance));
    assert_int_equal(guidance.waypoint, 0);
    const position_t inside = {28.0 - 199.0 / GEODESY_M_PER_DEG, -15.0};
    assert_true(plan_update(&plan, &inside, 50.0F, &guidance));
    assert_int_equal(guidance.waypoint, 1);
    assert_close(guidance.altitude_ft, 1000.0, 0.0);
}

static void the_capture_radius_grows_with_the_square_of_the_speed(void** state)
{
    (void)state;
    assert_close(plan_capture_radius_m(30.0F), 200.0, 0.0);
    assert_close(plan_capture_radius_m(55.0F), 200.0, 0.0);
    // 100 kt = 51.4444 m/s: 1.5 V^2 / (g tan 30 deg)
    assert_close(plan_capture_radius_m(100.0F), 701.15, 0.5);
    assert_close(plan_capture_radius_m(NAN), 200.0, 0.0);
}

static void after_the_last_waypoint_a_loop_begins_again(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(true);
    plan_guidance_t guidance;
    for (size_t i = 0; i < 3; i++)
    {
        assert_true(plan_update(&plan, &three[i].position, 55.0F, &guidance));
    }
    assert_int_equal(guidance.waypoint, 0);
    assert_false(plan.holding);
}

static void after_the_last_waypoint_it_is_circled_to_the_right(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(false);
    assert_true(plan_go_to(&plan, 2));
    plan_guidance_t guidance;
    const float radius_m = plan_capture_radius_m(50.0F);
    const position_t on_circle = {28.2 - ((double)radius_m - 1.0) / GEODESY_M_PER_DEG, -15.0};
    assert_true(plan_update(&plan, &on_circle, 50.0F, &guidance));
    assert_true(plan.holding);
    assert_int_equal(guidance.waypoint, 2);
    // south of the point: it lies to the north, and flying west keeps it on the right
    assert_close(guidance.bearing_deg, 0.0, 0.01);
    assert_close(guidance.course_deg, 270.0, 1.0);
    const position_t far = {28.1, -15.0};
    assert_true(plan_update(&plan, &far, 50.0F, &guidance));
    assert_close(guidance.course_deg, 360.0, 1.0); // straight back to it
    const position_t near = {28.2 - 20.0 / GEODESY_M_PER_DEG, -15.0};
    assert_true(plan_update(&plan, &near, 50.0F, &guidance));
    assert_in_range((int)guidance.course_deg, 195, 240); // outwards
}

static void next_previous_and_go_to_stop_at_the_ends(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(false);
    assert_false(plan_previous(&plan));
    assert_true(plan_next(&plan));
    assert_true(plan_next(&plan));
    assert_false(plan_next(&plan));
    assert_int_equal(plan.current, 2);
    assert_true(plan_previous(&plan));
    assert_int_equal(plan.current, 1);
    assert_true(plan_go_to(&plan, 0));
    assert_false(plan_go_to(&plan, 3));
    assert_false(plan_go_to(&plan, -1));
    assert_int_equal(plan.current, 0);
}

static void in_a_loop_next_and_previous_go_round(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(true);
    assert_true(plan_previous(&plan));
    assert_int_equal(plan.current, 2);
    assert_true(plan_next(&plan));
    assert_int_equal(plan.current, 0);
}

static void choosing_another_waypoint_ends_the_circling(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(false);
    plan.current = 2;
    plan.holding = true;
    assert_true(plan_previous(&plan));
    assert_false(plan.holding);
}

static void a_plan_is_replaced_whole_or_not_at_all(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(true);
    plan.current = 1;
    waypoint_t changed[3];
    memcpy(changed, three, sizeof changed);
    changed[2].position.latitude_deg = (double)NAN;
    assert_false(plan_replace(&plan, changed, 3, false));
    assert_false(plan_replace(&plan, three, 0, false));
    static waypoint_t many[plan_waypoints_max + 1];
    for (size_t i = 0; i < plan_waypoints_max + 1; i++)
    {
        many[i] = three[0];
    }
    assert_false(plan_replace(&plan, many, plan_waypoints_max + 1, false));
    assert_int_equal(plan.count, 3);
    assert_int_equal(plan.current, 1);
    assert_true(plan.loop);
    assert_true(plan_replace(&plan, many, plan_waypoints_max, false));
    assert_int_equal(plan.count, plan_waypoints_max);
    assert_int_equal(plan.current, 0);
}

static void a_waypoint_that_cannot_be_flown_is_not_valid(void** state)
{
    (void)state;
    assert_true(waypoint_is_valid(&three[0]));
    const waypoint_t bad[] = {
        {{28.0, -15.0}, NAN, 55.0F},      {{28.0, -15.0}, -2001.0F, 55.0F}, {{28.0, -15.0}, 60001.0F, 55.0F},
        {{28.0, -15.0}, 1000.0F, -1.0F},  {{28.0, -15.0}, 1000.0F, 501.0F}, {{28.0, -15.0}, 1000.0F, NAN},
        {{128.0, -15.0}, 1000.0F, 55.0F},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
    {
        assert_false(waypoint_is_valid(&bad[i]));
    }
}

static void a_position_that_is_none_gives_no_guidance_and_changes_nothing(void** state)
{
    (void)state;
    plan_t plan = plan_of_three(false);
    const position_t nowhere = {(double)NAN, -15.0};
    plan_guidance_t guidance;
    assert_false(plan_update(&plan, &nowhere, 55.0F, &guidance));
    assert_int_equal(plan.current, 0);
}

static void all_four_routes_are_plans_that_end_at_the_airport(void** state)
{
    (void)state;
    const size_t counts[ROUTE_COUNT] = {8, 20, 11, 10};
    const position_t airport = {27.9319, -15.3866};
    for (size_t i = 0; i < ROUTE_COUNT; i++)
    {
        assert_int_equal(routes[i].count, counts[i]);
        for (size_t j = 0; j < routes[i].count; j++)
        {
            const route_waypoint_t* const from = &routes[i].waypoints[j];
            const waypoint_t waypoint = {{from->latitude_deg, from->longitude_deg}, from->altitude_ft, from->speed_kt};
            assert_true(waypoint_is_valid(&waypoint));
        }
        const route_waypoint_t* const last = &routes[i].waypoints[routes[i].count - 1];
        const position_t end = {last->latitude_deg, last->longitude_deg};
        assert_true(geodesy_distance_m(&end, &airport) < 1.0F);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_empty_plan_gives_no_guidance),
        cmocka_unit_test(guidance_leads_to_the_waypoint_with_its_altitude_and_speed),
        cmocka_unit_test(the_next_waypoint_comes_inside_of_the_capture_radius),
        cmocka_unit_test(the_capture_radius_grows_with_the_square_of_the_speed),
        cmocka_unit_test(after_the_last_waypoint_a_loop_begins_again),
        cmocka_unit_test(after_the_last_waypoint_it_is_circled_to_the_right),
        cmocka_unit_test(next_previous_and_go_to_stop_at_the_ends),
        cmocka_unit_test(in_a_loop_next_and_previous_go_round),
        cmocka_unit_test(choosing_another_waypoint_ends_the_circling),
        cmocka_unit_test(a_plan_is_replaced_whole_or_not_at_all),
        cmocka_unit_test(a_waypoint_that_cannot_be_flown_is_not_valid),
        cmocka_unit_test(a_position_that_is_none_gives_no_guidance_and_changes_nothing),
        cmocka_unit_test(all_four_routes_are_plans_that_end_at_the_airport),
    };
    return cmocka_run_group_tests_name("navigation.plan", tests, NULL, NULL);
}
