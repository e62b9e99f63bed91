#include "support/cmocka_all.h"

#include <math.h>
#include <string.h>

#include "support/rig.h"

static int send_item(rig_t* rig, int32_t plan, int32_t index, double latitude_deg, float speed_kt)
{
    const command_mission_item_t values = {
        .plan = plan,
        .index = index,
        .latitude_deg = latitude_deg,
        .longitude_deg = -15.123456789012,
        .altitude_ft = 1000.0F + (float)index,
        .speed_kt = speed_kt,
    };
    uint8_t payload[COMMAND_MISSION_ITEM_SIZE];
    command_mission_item_pack(&values, payload);
    return rig_ask(rig, COMMAND_MISSION_ITEM_ID, payload, sizeof payload);
}

static void upload(rig_t* rig, int32_t plan, int32_t count)
{
    assert_int_equal(rig_ask_with_two(rig, COMMAND_MISSION_BEGIN_ID, plan, count), command_done);
    for (int32_t i = 0; i < count; i++)
    {
        assert_int_equal(send_item(rig, plan, i, 28.0 + (double)i / 100.0, 55.0F), command_done);
    }
    assert_int_equal(rig_ask_with(rig, COMMAND_MISSION_COMMIT_ID, plan), command_done);
}

static void the_board_says_who_it_is_and_what_it_can_do(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig->now_ms = 123456;
    (void)rig_do(rig, COMMAND_CAPABILITIES_ID);
    message_capabilities_t values;
    message_capabilities_unpack(&values, line_newest(&rig->out, MESSAGE_CAPABILITIES_ID)->payload);
    assert_int_equal(values.protocol_version, 1);
    assert_int_equal(values.features, 111);
    assert_string_equal(values.firmware_name, BOARD_FIRMWARE_NAME);
    assert_string_equal(values.firmware_version, BOARD_FIRMWARE_VERSION);
    assert_int_equal(values.uptime_ms, 123456);
    assert_int_equal(line_count_of(&rig->out, MESSAGE_ACKNOWLEDGEMENT_ID), 1);
}

static void without_a_card_nothing_can_be_stored_and_it_says_so(void** state)
{
    (void)state;
    rig_t* const rig = rig_start_without_card();
    (void)rig_do(rig, COMMAND_CAPABILITIES_ID);
    message_capabilities_t values;
    message_capabilities_unpack(&values, line_newest(&rig->out, MESSAGE_CAPABILITIES_ID)->payload);
    assert_int_equal(values.features & MESSAGE_CAPABILITIES_BIT_HAS_STORE, 0);
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_storage_failed);
}

static void a_card_that_fails_is_told(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_done);
    rig->card.has_failed = true;
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_storage_failed);
}

static void sources_are_selected_and_told_in_the_status(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with(rig, COMMAND_SELECT_AIRSPEED_SOURCE_ID, 0), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_SELECT_ALTITUDE_SOURCE_ID, 0), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_SELECT_AIRSPEED_SOURCE_ID, 2), command_bad_value);
    assert_int_equal(rig_ask_with(rig, COMMAND_SELECT_ALTITUDE_SOURCE_ID, -1), command_bad_value);
    line_clear(&rig->out);
    (void)board_tick(&rig->board, 1000);
    message_board_status_t status;
    message_board_status_unpack(&status, line_newest(&rig->out, MESSAGE_BOARD_STATUS_ID)->payload);
    assert_int_equal(status.airspeed_source, 0);
    assert_int_equal(status.altitude_source, 0);
    assert_int_equal(rig_ask_with(rig, COMMAND_SELECT_ALTITUDE_SOURCE_ID, 1), command_done);
    assert_int_equal(rig->board.flight.altitude_source, 1);
}

static void an_uploaded_plan_is_read_back_to_the_bit(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    upload(rig, board_plan_flight, plan_waypoints_max);
    (void)rig_do_with(rig, COMMAND_MISSION_READ_ID, board_plan_flight);
    message_mission_count_t count;
    message_mission_count_unpack(&count, line_newest(&rig->out, MESSAGE_MISSION_COUNT_ID)->payload);
    assert_int_equal(count.plan, board_plan_flight);
    assert_int_equal(count.count, plan_waypoints_max);
    size_t ticks = 0;
    do
    {
        ticks++;
    } while (board_tick(&rig->board, rig->now_ms));
    assert_int_equal(ticks, plan_waypoints_max);
    assert_int_equal(line_count_of(&rig->out, MESSAGE_MISSION_ITEM_ID), plan_waypoints_max);
    for (int32_t i = 0; i < plan_waypoints_max; i++)
    {
        message_mission_item_t item;
        message_mission_item_unpack(&item, rig->out.frames[rig->out.count - plan_waypoints_max + (size_t)i].payload);
        assert_int_equal(item.index, i);
        assert_true(item.latitude_deg == 28.0 + (double)i / 100.0);
        assert_true(item.longitude_deg == -15.123456789012);
        assert_close(item.altitude_ft, 1000.0 + i, 0.0);
    }
}

static void an_empty_plan_reads_as_none(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with(rig, COMMAND_MISSION_READ_ID, board_plan_hil), command_done);
    message_mission_count_t count;
    message_mission_count_unpack(&count, line_newest(&rig->out, MESSAGE_MISSION_COUNT_ID)->payload);
    assert_int_equal(count.count, 0);
    line_clear(&rig->out);
    assert_false(board_tick(&rig->board, rig->now_ms));
    assert_int_equal(rig->out.count, 0);
}

static void the_plan_in_use_stays_until_the_commit(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_MISSION_BEGIN_ID, board_plan_hil, 2), command_done);
    assert_int_equal(send_item(rig, board_plan_hil, 0, 28.0, 55.0F), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_MISSION_COMMIT_ID, board_plan_hil), command_bad_state);
    assert_int_equal(rig->board.plans.plan[board_plan_hil].count, 8);
    assert_int_equal(rig->board.plans.hil_route, 0);
    assert_int_equal(send_item(rig, board_plan_hil, 1, 28.1, 55.0F), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_MISSION_COMMIT_ID, board_plan_hil), command_done);
    assert_int_equal(rig->board.plans.plan[board_plan_hil].count, 2);
    assert_int_equal(rig->board.plans.hil_route, -1);
}

static void what_cannot_be_uploaded_is_refused_with_its_reason(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_MISSION_BEGIN_ID, 2, 3), command_bad_value);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_MISSION_BEGIN_ID, 0, 0), command_bad_value);
    assert_int_equal(send_item(rig, 0, 0, 28.0, 55.0F), command_bad_state);
    assert_int_equal(send_item(rig, 7, 0, 28.0, 55.0F), command_bad_value);
    assert_int_equal(rig_ask_with(rig, COMMAND_MISSION_COMMIT_ID, 0), command_bad_state);
    assert_int_equal(rig_ask_with(rig, COMMAND_MISSION_COMMIT_ID, -1), command_bad_value);
    assert_int_equal(rig_ask_with(rig, COMMAND_MISSION_READ_ID, 2), command_bad_value);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_MISSION_BEGIN_ID, 0, 1), command_done);
    assert_int_equal(send_item(rig, 0, 0, (double)NAN, 55.0F), command_bad_value);
    assert_int_equal(send_item(rig, 0, 0, 28.0, 600.0F), command_bad_value);
}

static void a_read_back_ends_when_its_plan_is_replaced(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    (void)rig_do(rig, COMMAND_HIL_LOAD_RUTA_ISLA_ID);
    (void)rig_do_with(rig, COMMAND_MISSION_READ_ID, board_plan_hil);
    assert_true(board_tick(&rig->board, rig->now_ms));
    (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID);
    line_clear(&rig->out);
    assert_false(board_tick(&rig->board, rig->now_ms));
    assert_int_equal(rig->out.count, 0);
    (void)rig_do_with(rig, COMMAND_MISSION_READ_ID, board_plan_hil);
    assert_true(board_tick(&rig->board, rig->now_ms));
    upload(rig, board_plan_hil, 5);
    line_clear(&rig->out);
    assert_false(board_tick(&rig->board, rig->now_ms));
    assert_int_equal(rig->out.count, 0);
}

static void go_to_chooses_a_waypoint_of_its_plan(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_GO_TO_WAYPOINT_ID, board_plan_hil, 0), command_bad_state);
    (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_GO_TO_WAYPOINT_ID, board_plan_hil, 5), command_done);
    assert_int_equal(rig->board.plans.plan[board_plan_hil].current, 5);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_GO_TO_WAYPOINT_ID, board_plan_hil, 8), command_bad_value);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_GO_TO_WAYPOINT_ID, board_plan_hil, -1), command_bad_value);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_GO_TO_WAYPOINT_ID, 9, 0), command_bad_value);
    assert_int_equal(rig->board.plans.plan[board_plan_hil].current, 5);
}

static void send_info(rig_t* rig, const command_xplane_info_t* info)
{
    uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
    command_xplane_info_pack(info, payload);
    line_clear(&rig->out);
    (void)rig_send(rig, COMMAND_XPLANE_INFO_ID, payload, sizeof payload);
    assert_int_equal(line_count_of(&rig->out, MESSAGE_HIL_SURFACES_ID), 1);
}

static message_hil_step_t told_step(const rig_t* rig)
{
    message_hil_step_t values;
    assert_int_equal(line_count_of(&rig->out, MESSAGE_HIL_STEP_ID), 1);
    message_hil_step_unpack(&values, line_newest(&rig->out, MESSAGE_HIL_STEP_ID)->payload);
    return values;
}

static void the_times_of_hil_steps_are_told_to_who_asks_until_the_line_is_opened_again(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    command_xplane_info_t info = rig_level_flight();
    send_info(rig, &info);
    assert_int_equal(line_count_of(&rig->out, MESSAGE_HIL_STEP_ID), 0);

    assert_int_equal(rig_ask(rig, COMMAND_HIL_STEPS_ON_ID, NULL, 0), command_done);
    rig->now_ms += 35;
    info.roll_deg += 1.0F;
    send_info(rig, &info);
    assert_int_equal(told_step(rig).clock_ms, rig->now_ms);
    assert_close(told_step(rig).step_s, 0.02F, 0.0);

    info.latitude_deg = NAN; // refused, yet answered
    send_info(rig, &info);
    assert_close(told_step(rig).step_s, 0.0, 0.0);

    board_open(&rig->board, rig->now_ms);
    send_info(rig, &info);
    assert_int_equal(line_count_of(&rig->out, MESSAGE_HIL_STEP_ID), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_board_says_who_it_is_and_what_it_can_do),
        cmocka_unit_test(without_a_card_nothing_can_be_stored_and_it_says_so),
        cmocka_unit_test(a_card_that_fails_is_told),
        cmocka_unit_test(sources_are_selected_and_told_in_the_status),
        cmocka_unit_test(an_uploaded_plan_is_read_back_to_the_bit),
        cmocka_unit_test(an_empty_plan_reads_as_none),
        cmocka_unit_test(the_plan_in_use_stays_until_the_commit),
        cmocka_unit_test(what_cannot_be_uploaded_is_refused_with_its_reason),
        cmocka_unit_test(a_read_back_ends_when_its_plan_is_replaced),
        cmocka_unit_test(go_to_chooses_a_waypoint_of_its_plan),
        cmocka_unit_test(the_times_of_hil_steps_are_told_to_who_asks_until_the_line_is_opened_again),
    };
    return cmocka_run_group_tests_name("flight.board_command_extensions", tests, NULL, NULL);
}
