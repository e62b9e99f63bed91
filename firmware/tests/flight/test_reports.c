#include "support/cmocka_all.h"

#include <string.h>

#include "flight/reports.h"
#include "support/line.h"

static line_t sent;

static void collect(void* context, const uint8_t* frame, size_t size)
{
    line_feed(context, frame, size, 0);
}

static const report_line_t line = {.send = collect, .context = &sent};

static int begin(void** state)
{
    (void)state;
    line_init(&sent, &frame_from_board);
    return 0;
}

static void surfaces_are_one_frame_each_in_the_order_of_their_message(void** state)
{
    (void)state;
    const surfaces_t surfaces = {.elevator = 0.1F, .aileron = 0.2F, .rudder = 0.3F, .throttle = 0.4F};
    report_hil_surfaces(&line, &surfaces);
    report_fly_by_wire(&line, &surfaces);
    assert_int_equal(sent.count, 2);
    message_hil_surfaces_t hil;
    message_hil_surfaces_unpack(&hil, line_newest(&sent, MESSAGE_HIL_SURFACES_ID)->payload);
    const message_hil_surfaces_t wanted_hil = {.elevator = 0.1F, .aileron = 0.2F, .rudder = 0.3F, .throttle = 0.4F};
    assert_memory_equal(&hil, &wanted_hil, sizeof hil);
    message_fly_by_wire_t flight;
    message_fly_by_wire_unpack(&flight, line_newest(&sent, MESSAGE_FLY_BY_WIRE_ID)->payload);
    const message_fly_by_wire_t wanted = {.elevator = 0.1F, .aileron = 0.2F, .rudder = 0.3F, .throttle = 0.4F};
    assert_memory_equal(&flight, &wanted, sizeof flight);
}

static void a_command_s_result_is_acknowledged_with_its_type(void** state)
{
    (void)state;
    report_acknowledgement(&line, 0x105, command_bad_value);
    message_acknowledgement_t values;
    message_acknowledgement_unpack(&values, line_newest(&sent, MESSAGE_ACKNOWLEDGEMENT_ID)->payload);
    assert_int_equal(values.command_type, 0x105);
    assert_int_equal(values.result, command_bad_value);
}

static void a_waypoint_is_reported_with_its_plan_and_index(void** state)
{
    (void)state;
    const waypoint_t waypoint = {.position = {27.95, -15.37}, .altitude_ft = 700.0F, .speed_kt = 55.0F};
    report_mission_count(&line, 1, 100);
    report_mission_item(&line, 1, 99, &waypoint);
    message_mission_count_t count;
    message_mission_count_unpack(&count, line_newest(&sent, MESSAGE_MISSION_COUNT_ID)->payload);
    assert_int_equal(count.plan, 1);
    assert_int_equal(count.count, 100);
    message_mission_item_t item;
    message_mission_item_unpack(&item, line_newest(&sent, MESSAGE_MISSION_ITEM_ID)->payload);
    assert_int_equal(item.plan, 1);
    assert_int_equal(item.index, 99);
    assert_close(item.latitude_deg, 27.95, 0.0);
    assert_close(item.longitude_deg, -15.37, 0.0);
    assert_close(item.altitude_ft, 700.0, 0.0);
    assert_close(item.speed_kt, 55.0, 0.0);
}

static void an_empty_plan_is_reported_as_absent_under_either_type(void** state)
{
    (void)state;
    const uint32_t types[] = {MESSAGE_FMS_PLAN_ID, MESSAGE_FMS_HIL_PLAN_ID};
    static plan_t plan;
    plan_clear(&plan);
    const position_t here = {27.93, -15.38};
    for (size_t i = 0; i < 2; i++)
    {
        report_plan(&line, types[i], &plan, &here, 55.0F);
        message_fms_plan_t values;
        message_fms_plan_unpack(&values, line_newest(&sent, types[i])->payload);
        assert_true(isnan(values.bearing_deg));
        assert_true(isnan(values.altitude_ft));
        assert_int_equal(values.waypoint, MESSAGE_FMS_PLAN_WAYPOINT_ABSENT);
        assert_int_equal(values.distance_m, MESSAGE_FMS_PLAN_DISTANCE_M_ABSENT);
    }
}

static void the_parameters_frame_is_the_one_of_the_definition(void** state)
{
    (void)state;
    parameters_t parameters;
    parameters_init(&parameters);
    report_parameters(&line, &parameters);
    message_autopilot_parameters_t values;
    message_autopilot_parameters_unpack(&values, line_newest(&sent, MESSAGE_AUTOPILOT_PARAMETERS_ID)->payload);
    const message_autopilot_parameters_t defaults = {
        .k_int_altura = 0.06F,
        .k_altura = 0.06F,
        .k_VVI = 0.1F,
        .k_pitch = 2.0F,
        .k_heading = 0.8F,
        .k_roll = 2.0F,
        .k_div_velocidad = 700,
        .k_div_P_init = 0.5F,
        .k_div_P_speed = 30.0F,
        .k_div_Q_init = 0.2F,
        .k_div_Q_speed = 40.0F,
        .k_div_R_init = 0.1F,
        .k_div_R_speed = 35.0F,
        .k_int_pitch = 0.6F,
        .k_elev = 1.0F,
        .k_airln = 0.6F,
        .k_rudder = 1.0F,
    };
    assert_memory_equal(&values, &defaults, sizeof values);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(surfaces_are_one_frame_each_in_the_order_of_their_message, begin),
        cmocka_unit_test_setup(a_command_s_result_is_acknowledged_with_its_type, begin),
        cmocka_unit_test_setup(a_waypoint_is_reported_with_its_plan_and_index, begin),
        cmocka_unit_test_setup(an_empty_plan_is_reported_as_absent_under_either_type, begin),
        cmocka_unit_test_setup(the_parameters_frame_is_the_one_of_the_definition, begin),
    };
    return cmocka_run_group_tests_name("flight.reports", tests, NULL, NULL);
}
