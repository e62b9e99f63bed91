#include "support/cmocka_all.h"

#include "navigation/mission.h"

static const waypoint_t here = {{28.0, -15.0}, 700.0F, 55.0F};
static const waypoint_t there = {{28.1, -15.1}, 900.0F, 60.0F};

static plan_t old_plan(void)
{
    plan_t plan;
    plan_clear(&plan);
    assert_true(plan_replace(&plan, &here, 1, true));
    return plan;
}

static void an_upload_replaces_the_plan_only_when_it_is_committed(void** state)
{
    (void)state;
    plan_t plan = old_plan();
    mission_t mission;
    mission_init(&mission);
    assert_int_equal(mission_begin(&mission, 1, 2), mission_ok);
    assert_int_equal(mission_item(&mission, 1, 1, &there), mission_ok);
    assert_int_equal(mission_item(&mission, 1, 0, &here), mission_ok);
    assert_int_equal(plan.count, 1);
    assert_int_equal(mission_commit(&mission, 1, &plan), mission_ok);
    assert_int_equal(plan.count, 2);
    assert_close(plan.waypoints[1].altitude_ft, 900.0, 0.0);
    assert_false(plan.loop);
    // it is used up
    assert_int_equal(mission_commit(&mission, 1, &plan), mission_bad_state);
}

static void a_missing_waypoint_refuses_the_commit_and_the_upload_may_go_on(void** state)
{
    (void)state;
    plan_t plan = old_plan();
    mission_t mission;
    mission_init(&mission);
    assert_int_equal(mission_begin(&mission, 0, 3), mission_ok);
    assert_int_equal(mission_item(&mission, 0, 0, &here), mission_ok);
    assert_int_equal(mission_item(&mission, 0, 2, &there), mission_ok);
    assert_int_equal(mission_commit(&mission, 0, &plan), mission_bad_state);
    assert_int_equal(plan.count, 1);
    assert_int_equal(mission_item(&mission, 0, 1, &there), mission_ok);
    assert_int_equal(mission_commit(&mission, 0, &plan), mission_ok);
    assert_int_equal(plan.count, 3);
}

static void without_a_begin_for_this_plan_nothing_is_taken(void** state)
{
    (void)state;
    plan_t plan = old_plan();
    mission_t mission;
    mission_init(&mission);
    assert_int_equal(mission_item(&mission, 0, 0, &here), mission_bad_state);
    assert_int_equal(mission_commit(&mission, 0, &plan), mission_bad_state);
    assert_int_equal(mission_begin(&mission, 1, 1), mission_ok);
    assert_int_equal(mission_item(&mission, 0, 0, &here), mission_bad_state);
    assert_int_equal(mission_item(&mission, 1, 0, &here), mission_ok);
    assert_int_equal(mission_commit(&mission, 0, &plan), mission_bad_state);
}

static void values_outside_of_their_range_are_refused_one_by_one(void** state)
{
    (void)state;
    mission_t mission;
    mission_init(&mission);
    assert_int_equal(mission_begin(&mission, 0, 0), mission_bad_value);
    assert_int_equal(mission_begin(&mission, 0, 101), mission_bad_value);
    assert_int_equal(mission_begin(&mission, 0, 100), mission_ok);
    assert_int_equal(mission_item(&mission, 0, 100, &here), mission_bad_value);
    assert_int_equal(mission_item(&mission, 0, -1, &here), mission_bad_value);
    waypoint_t bad = here;
    bad.speed_kt = NAN;
    assert_int_equal(mission_item(&mission, 0, 0, &bad), mission_bad_value);
    assert_false(mission.received[0]);
}

static void a_refused_begin_leaves_the_running_upload_alone(void** state)
{
    (void)state;
    plan_t plan = old_plan();
    mission_t mission;
    mission_init(&mission);
    assert_int_equal(mission_begin(&mission, 0, 1), mission_ok);
    assert_int_equal(mission_item(&mission, 0, 0, &there), mission_ok);
    assert_int_equal(mission_begin(&mission, 0, 500), mission_bad_value);
    assert_int_equal(mission_commit(&mission, 0, &plan), mission_ok);
    assert_close(plan.waypoints[0].altitude_ft, 900.0, 0.0);
}

static void a_new_begin_forgets_what_came_before(void** state)
{
    (void)state;
    plan_t plan = old_plan();
    mission_t mission;
    mission_init(&mission);
    assert_int_equal(mission_begin(&mission, 0, 1), mission_ok);
    assert_int_equal(mission_item(&mission, 0, 0, &there), mission_ok);
    assert_int_equal(mission_begin(&mission, 0, 1), mission_ok);
    assert_int_equal(mission_commit(&mission, 0, &plan), mission_bad_state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_upload_replaces_the_plan_only_when_it_is_committed),
        cmocka_unit_test(a_missing_waypoint_refuses_the_commit_and_the_upload_may_go_on),
        cmocka_unit_test(without_a_begin_for_this_plan_nothing_is_taken),
        cmocka_unit_test(values_outside_of_their_range_are_refused_one_by_one),
        cmocka_unit_test(a_refused_begin_leaves_the_running_upload_alone),
        cmocka_unit_test(a_new_begin_forgets_what_came_before),
    };
    return cmocka_run_group_tests_name("navigation.mission", tests, NULL, NULL);
}
