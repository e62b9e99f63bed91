#include "support/cmocka_all.h"

#include "navigation/legs.h"

static const float dt_s = 0.02F;

/// 2 km to the north, then 2 km to the east.
static const waypoint_t waypoints[] = {
    {{27.9180, -15.4000}, 1000.0F, 55.0F},
    {{27.9180, -15.3796}, 1200.0F, 60.0F},
};

typedef struct
{
    legs_t legs;
    plan_t plan;
    legs_input_t input;
    legs_guidance_t guidance;
} navigation_t;

static void start(navigation_t* flown)
{
    *flown = (navigation_t){
        .input = {.position = {27.9, -15.4},
                  .airspeed_m_s = 28.0F,
                  .altitude_ft = 1000.0F,
                  .bank_deg = 30.0F,
                  .roll_time_s = 0.0F},
    };
    legs_init(&flown->legs);
    plan_clear(&flown->plan);
    assert_true(plan_replace(&flown->plan, waypoints, 2, false));
}

static void move(navigation_t* flown, double north_m, double east_m)
{
    flown->input.position.latitude_deg += north_m / GEODESY_M_PER_DEG;
    flown->input.position.longitude_deg += east_m / GEODESY_M_PER_DEG / 0.8837;
    assert_true(legs_update(&flown->legs, &flown->plan, &flown->input, dt_s, &flown->guidance));
}

static void the_first_leg_begins_where_the_aircraft_is(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    move(&flown, 500.0, 300.0);
    assert_close(flown.guidance.right_m, 0.0, 0.1);
    move(&flown, 100.0, 0.0);
    assert_true(flown.guidance.right_m > 10.0F);
    assert_close(flown.guidance.altitude_ft, 1000.0, 0.0);
    assert_close(flown.guidance.speed_kt, 55.0, 0.0);
}

static void a_command_to_another_waypoint_begins_a_leg_from_there(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    move(&flown, 0.0, 0.0);
    move(&flown, 500.0, 400.0);
    assert_true(plan_go_to(&flown.plan, 1));
    move(&flown, 0.0, 0.0);
    assert_close(flown.guidance.right_m, 0.0, 0.1);
    assert_close(flown.guidance.altitude_ft, 1200.0, 0.0);
    move(&flown, 0.0, 100.0);
    assert_true(plan_replace(&flown.plan, waypoints, 2, false)); // a new plan, the same waypoint's number
    move(&flown, 0.0, 0.0);
    assert_close(flown.guidance.right_m, 0.0, 0.1);
}

static void the_turn_begins_a_radius_before_a_right_angle(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    move(&flown, 0.0, 0.0);
    move(&flown, 2001.0 - 150.0, 0.0);
    assert_int_equal(flown.plan.current, 0);
    move(&flown, 15.0, 0.0);
    assert_int_equal(flown.plan.current, 1);
    assert_close(flown.guidance.course_deg, 90.0, 0.1);
    assert_close(flown.guidance.right_m, 136.0, 3.0); // south of the line to the east
}

/// Fly the corner by the chord of the turn, at `altitude_ft`, `beside_m` to the right of it.
static void fly_corner(navigation_t* flown, float altitude_ft, double beside_m)
{
    move(flown, 0.0, 0.0);
    flown->input.altitude_ft = altitude_ft;
    move(flown, 2001.0 - 135.0, beside_m);
    assert_int_equal(flown->plan.current, 1);
    for (int i = 0; i < 14; i++)
    {
        move(flown, 10.0, 10.0);
    }
}

static void a_waypoint_is_captured_where_the_bisector_is_passed(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    fly_corner(&flown, 1030.0F, 0.0);
    assert_false(flown.legs.is_passing);
    assert_int_equal(flown.legs.captured, 1);
    assert_int_equal(flown.legs.missed, 0);
    assert_true(flown.legs.passage.is_captured);
    assert_int_equal(flown.legs.passage.waypoint, 0);
    assert_close(flown.legs.passage.distance_m, 95.0, 8.0);
    assert_close(flown.legs.passage.altitude_error_ft, 30.0, 0.01);
}

static void its_altitude_is_held_until_then(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    move(&flown, 0.0, 0.0);
    move(&flown, 2001.0 - 135.0, 0.0);
    assert_true(flown.legs.is_passing);
    assert_close(flown.guidance.altitude_ft, 1000.0, 0.0);
    move(&flown, 140.0, 140.0);
    assert_close(flown.guidance.altitude_ft, 1200.0, 0.0);
}

static void too_high_or_too_far_is_a_miss(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    fly_corner(&flown, 1130.0F, 0.0);
    assert_int_equal(flown.legs.captured, 0);
    assert_int_equal(flown.legs.missed, 1);
    assert_false(flown.legs.passage.is_captured);
    start(&flown);
    fly_corner(&flown, 1000.0F, 300.0);
    assert_int_equal(flown.legs.captured, 0);
    assert_int_equal(flown.legs.missed, 1);
}

static void a_leg_too_short_for_its_turns_says_so_and_turns_at_its_middle(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    flown.input.position.latitude_deg = 27.9162; // 200 m before the corner
    move(&flown, 0.0, 0.0);
    assert_true(flown.legs.is_short);
    assert_int_equal(flown.plan.current, 0);
    move(&flown, 95.0, 0.0);
    assert_int_equal(flown.plan.current, 0);
    move(&flown, 10.0, 0.0);
    assert_int_equal(flown.plan.current, 1);
}

static void the_last_waypoint_is_flown_over_and_circled_clockwise(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    assert_true(plan_go_to(&flown.plan, 1));
    flown.input.position = waypoints[0].position;
    flown.input.altitude_ft = 1200.0F;
    move(&flown, 0.0, 0.0);
    move(&flown, 0.0, 2000.0);
    assert_false(flown.plan.holding);
    move(&flown, 0.0, 10.0);
    assert_true(flown.plan.holding);
    assert_int_equal(flown.plan.current, 1);
    assert_int_equal(flown.legs.captured, 1);
    move(&flown, 300.0, 0.0); // north of it
    assert_close(flown.guidance.course_deg, 90.0, 3.0);
    assert_true(flown.guidance.curvature_per_m > 0.0F);
    assert_true(flown.guidance.right_m < 0.0F); // outside of the circle: left of its line
}

static void after_the_last_waypoint_of_a_loop_comes_the_first(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    assert_true(plan_replace(&flown.plan, waypoints, 2, true));
    assert_true(plan_go_to(&flown.plan, 1));
    flown.input.position = waypoints[0].position;
    move(&flown, 0.0, 0.0);
    move(&flown, 0.0, 2100.0);
    assert_int_equal(flown.plan.current, 0);
    assert_false(flown.plan.holding);
}

static void without_a_plan_or_a_position_it_asks_for_nothing(void** state)
{
    (void)state;
    navigation_t flown;
    start(&flown);
    flown.input.position.latitude_deg = (double)NAN;
    assert_false(legs_update(&flown.legs, &flown.plan, &flown.input, dt_s, &flown.guidance));
    start(&flown);
    plan_clear(&flown.plan);
    assert_false(legs_update(&flown.legs, &flown.plan, &flown.input, dt_s, &flown.guidance));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_leg_begins_where_the_aircraft_is),
        cmocka_unit_test(a_command_to_another_waypoint_begins_a_leg_from_there),
        cmocka_unit_test(the_turn_begins_a_radius_before_a_right_angle),
        cmocka_unit_test(a_waypoint_is_captured_where_the_bisector_is_passed),
        cmocka_unit_test(its_altitude_is_held_until_then),
        cmocka_unit_test(too_high_or_too_far_is_a_miss),
        cmocka_unit_test(a_leg_too_short_for_its_turns_says_so_and_turns_at_its_middle),
        cmocka_unit_test(the_last_waypoint_is_flown_over_and_circled_clockwise),
        cmocka_unit_test(after_the_last_waypoint_of_a_loop_comes_the_first),
        cmocka_unit_test(without_a_plan_or_a_position_it_asks_for_nothing),
    };
    return cmocka_run_group_tests_name("navigation.legs", tests, NULL, NULL);
}
