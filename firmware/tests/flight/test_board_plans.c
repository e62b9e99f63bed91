#include "support/cmocka_all.h"

#include "flight/board_plans.h"
#include "navigation/routes_gen.h"

static board_plans_t plans;

/// Upload `count` waypoints into `plan`.
static mission_status_t upload(int32_t plan, int32_t count, bool has_card)
{
    assert_int_equal(mission_begin(&plans.upload, plan, count), mission_ok);
    for (int32_t i = 0; i < count; i++)
    {
        const waypoint_t waypoint = {.position = {28.0 + (double)i / 100.0, -15.0}, .altitude_ft = 900, .speed_kt = 55};
        assert_int_equal(mission_item(&plans.upload, plan, i, &waypoint), mission_ok);
    }
    return board_plans_commit(&plans, plan, has_card);
}

static int begin(void** state)
{
    (void)state;
    board_plans_init(&plans);
    return 0;
}

static void both_plans_begin_empty_and_unnamed(void** state)
{
    (void)state;
    assert_int_equal(plans.plan[board_plan_flight].count, 0);
    assert_int_equal(plans.plan[board_plan_hil].count, 0);
    assert_int_equal(plans.hil_route, -1);
    assert_false(board_plans_is_reading(&plans));
}

static void only_two_numbers_are_plans(void** state)
{
    (void)state;
    assert_true(board_plans_has(board_plan_flight));
    assert_true(board_plans_has(board_plan_hil));
    assert_false(board_plans_has(-1));
    assert_false(board_plans_has(board_plan_count));
}

static void an_uploaded_plan_is_to_be_stored_where_there_is_a_card(void** state)
{
    (void)state;
    assert_int_equal(upload(board_plan_flight, 2, false), mission_ok);
    assert_false(plans.is_to_store[board_plan_flight]);
    assert_int_equal(upload(board_plan_flight, 3, true), mission_ok);
    assert_true(plans.is_to_store[board_plan_flight]);
    assert_int_equal(plans.plan[board_plan_flight].count, 3);
    assert_int_equal(plans.plan[board_plan_hil].count, 0);
}

static void an_upload_that_is_not_complete_changes_nothing(void** state)
{
    (void)state;
    assert_true(board_plans_load_route(&plans, ROUTE_GANDO));
    board_plans_begin_reading(&plans, board_plan_hil);
    assert_int_equal(mission_begin(&plans.upload, board_plan_hil, 2), mission_ok);
    assert_int_equal(board_plans_commit(&plans, board_plan_hil, true), mission_bad_state);
    assert_int_equal(plans.hil_route, ROUTE_GANDO);
    assert_int_equal(plans.plan[board_plan_hil].count, routes[ROUTE_GANDO].count);
    assert_false(plans.is_to_store[board_plan_hil]);
    assert_true(board_plans_is_reading(&plans));
}

static void a_route_takes_the_place_of_an_upload_and_is_not_stored(void** state)
{
    (void)state;
    assert_int_equal(upload(board_plan_hil, 2, true), mission_ok);
    assert_int_equal(plans.hil_route, -1);
    assert_true(board_plans_load_route(&plans, ROUTE_VUELO));
    assert_int_equal(plans.hil_route, ROUTE_VUELO);
    assert_false(plans.is_to_store[board_plan_hil]);
}

static void a_plan_is_read_back_waypoint_by_waypoint(void** state)
{
    (void)state;
    assert_int_equal(upload(board_plan_flight, 3, true), mission_ok);
    board_plans_begin_reading(&plans, board_plan_flight);
    for (size_t i = 0; i < 3; i++)
    {
        size_t index = 99;
        assert_true(board_plans_is_reading(&plans));
        assert_ptr_equal(board_plans_read_next(&plans, &index), &plans.plan[board_plan_flight].waypoints[i]);
        assert_int_equal(index, i);
    }
    size_t index = 0;
    assert_false(board_plans_is_reading(&plans));
    assert_null(board_plans_read_next(&plans, &index));
}

static void an_empty_plan_has_nothing_to_read(void** state)
{
    (void)state;
    size_t index = 0;
    board_plans_begin_reading(&plans, board_plan_hil);
    assert_null(board_plans_read_next(&plans, &index));
    assert_false(board_plans_is_reading(&plans));
}

static void a_new_plan_ends_the_reading(void** state)
{
    (void)state;
    assert_true(board_plans_load_route(&plans, ROUTE_GANDO));
    board_plans_begin_reading(&plans, board_plan_hil);
    assert_int_equal(upload(board_plan_hil, 2, true), mission_ok);
    assert_false(board_plans_is_reading(&plans));
    board_plans_begin_reading(&plans, board_plan_hil);
    assert_true(board_plans_load_route(&plans, ROUTE_GANDO));
    assert_false(board_plans_is_reading(&plans));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(both_plans_begin_empty_and_unnamed, begin),
        cmocka_unit_test_setup(only_two_numbers_are_plans, begin),
        cmocka_unit_test_setup(an_uploaded_plan_is_to_be_stored_where_there_is_a_card, begin),
        cmocka_unit_test_setup(an_upload_that_is_not_complete_changes_nothing, begin),
        cmocka_unit_test_setup(a_route_takes_the_place_of_an_upload_and_is_not_stored, begin),
        cmocka_unit_test_setup(a_plan_is_read_back_waypoint_by_waypoint, begin),
        cmocka_unit_test_setup(an_empty_plan_has_nothing_to_read, begin),
        cmocka_unit_test_setup(a_new_plan_ends_the_reading, begin),
    };
    return cmocka_run_group_tests_name("flight.board_plans", tests, NULL, NULL);
}
