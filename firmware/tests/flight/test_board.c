#include "support/cmocka_all.h"

#include <string.h>

#include "flight/board.h"
#include "support/rig.h"

static void after_power_on_the_control_source_is_rc_and_everything_is_off(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    const message_heartbeat_t heartbeat = rig_heartbeat(rig);
    const message_heartbeat_t all_off = {0};
    assert_memory_equal(&heartbeat, &all_off, sizeof heartbeat);
    assert_int_equal(rig->out.count, 1);
    assert_int_equal(rig->board.plans.hil_route, -1);
    assert_int_equal(rig->board.plans.plan[board_plan_hil].count, 0);
}

static void before_the_station_asks_nothing_is_acknowledged(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do(rig, COMMAND_AHRS_ON_ID);
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 7);
    (void)rig_do(rig, 12345);
    assert_int_equal(rig->out.count, 0);
    for (uint32_t now_ms = 0; now_ms < 5000; now_ms += 10)
    {
        (void)board_tick(&rig->board, now_ms);
    }
    assert_int_equal(rig->out.count, 0);
}

static void once_asked_every_command_but_0_and_50_is_acknowledged(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask(rig, COMMAND_AHRS_ON_ID, NULL, 0), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_CONTROL_SOURCE_ID, 7), command_bad_value);
    assert_int_equal(rig_ask(rig, 12345, NULL, 0), command_unknown);
    assert_int_equal(rig_ask(rig, COMMAND_STOP_ID, NULL, 0), command_done);
    (void)rig_do(rig, COMMAND_DO_NOTHING_ID);
    assert_int_equal(rig->out.count, 0);
    const command_xplane_info_t info = rig_level_flight();
    (void)rig_fly(rig, &info);
    assert_int_equal(line_count_of(&rig->out, MESSAGE_ACKNOWLEDGEMENT_ID), 0);
}

static void a_station_that_opens_the_line_anew_has_to_ask_anew(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    board_open(&rig->board, 100);
    (void)rig_do(rig, COMMAND_AHRS_ON_ID);
    assert_int_equal(rig->out.count, 0);
    assert_int_equal(rig_heartbeat(rig).ahrs, 1); // modes and streams stay
}

static void a_deployed_board_knows_no_extension(void** state)
{
    (void)state;
    rig_t* const rig = rig_start_legacy();
    (void)rig_do(rig, COMMAND_CAPABILITIES_ID);
    assert_int_equal(rig->out.count, 0);
    (void)rig_do_with(rig, COMMAND_MISSION_READ_ID, 1);
    (void)rig_do_with(rig, COMMAND_SELECT_AIRSPEED_SOURCE_ID, 0);
    (void)rig_do(rig, COMMAND_STORE_PARAMETERS_ID);
    (void)rig_do(rig, COMMAND_AHRS_ON_ID);
    (void)board_tick(&rig->board, 100000);
    assert_int_equal(rig->out.count, 0);
    assert_int_equal(rig->board.flight.airspeed_source, 1);
    assert_int_equal(rig->card.count, 0);
    assert_int_equal(rig_heartbeat(rig).ahrs, 1);
}

static void the_status_comes_once_a_second(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    board_note_frames(&rig->board, 12, 3);
    for (uint32_t now_ms = 10; now_ms <= 5000; now_ms += 10)
    {
        (void)board_tick(&rig->board, now_ms);
    }
    assert_int_equal(line_count_of(&rig->out, MESSAGE_BOARD_STATUS_ID), 5);
    message_board_status_t status;
    message_board_status_unpack(&status, line_newest(&rig->out, MESSAGE_BOARD_STATUS_ID)->payload);
    assert_int_equal(status.frames_received, 12);
    assert_int_equal(status.frames_rejected, 3);
    assert_int_equal(status.hil_plan_name, -1);
}

static void exit_and_reset_are_for_the_application_and_acknowledged_first(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_do(rig, COMMAND_EXIT_BINARY_MODE_ID), board_leaves_binary_mode);
    assert_int_equal(rig->out.count, 1);
    assert_int_equal(rig_do(rig, COMMAND_RESET_ID), board_resets);
    assert_int_equal(rig->out.count, 1);
    assert_int_equal(rig_do(rig, COMMAND_STOP_ID), board_goes_on);
    assert_int_equal(rig_send(rig, COMMAND_RESET_ID, (const uint8_t*)"1234", 4), board_goes_on);
}

static void streams_that_are_on_are_sent_by_their_task_alone(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do(rig, COMMAND_GPS_ON_ID);
    (void)rig_do(rig, COMMAND_AHRS_ON_ID);
    line_clear(&rig->out);
    board_send_streams(&rig->board, telemetry_task_fms);
    assert_int_equal(rig->out.count, 1);
    assert_int_equal(rig->out.frames[0].type_id, MESSAGE_GPS_ID);
    line_clear(&rig->out);
    board_send_streams(&rig->board, telemetry_task_param);
    assert_int_equal(rig->out.count, 2);
    assert_int_equal(rig->out.frames[0].type_id, MESSAGE_HEARTBEAT_ID);
    assert_int_equal(rig->out.frames[1].type_id, MESSAGE_AHRS_ID);
    line_clear(&rig->out);
    board_send_streams(&rig->board, telemetry_task_servos);
    assert_int_equal(rig->out.count, 0);
}

static void servo_outputs_follow_the_law_that_was_chosen(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig->board.flight.loop.surfaces = (surfaces_t){0.1F, 0.2F, 0.3F, 0.4F};
    rig->board.hil.loop.surfaces = (surfaces_t){-0.1F, -0.2F, -0.3F, 0.9F};
    float positions[board_servo_count];
    board_servo_positions(&rig->board, positions);
    assert_close(positions[rc_channel_elevator], 0.1, 1e-6);
    assert_close(positions[rc_channel_aileron], 0.2, 1e-6);
    assert_close(positions[rc_channel_rudder], 0.3, 1e-6);
    assert_close(positions[rc_channel_throttle], 0.4, 1e-6);
    (void)rig_do(rig, COMMAND_SERVOS_CONTROL_MODE_HIL_ID);
    board_servo_positions(&rig->board, positions);
    assert_close(positions[rc_channel_elevator], -0.1, 1e-6);
    assert_close(positions[rc_channel_throttle], 0.9, 1e-6);
    (void)rig_do(rig, COMMAND_SERVOS_CONTROL_MODE_FLY_BY_WIRE_ID);
    board_servo_positions(&rig->board, positions);
    assert_close(positions[rc_channel_elevator], 0.1, 1e-6);
}

static void stored_parameters_are_there_after_the_next_power_on(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    uint8_t payload[4];
    protocol_put_f32(payload, 2.5F);
    (void)rig_send(rig, COMMAND_SET_K_PITCH_ID, payload, sizeof payload);
    (void)rig_do(rig, COMMAND_STORE_PARAMETERS_ID);
    const board_config_t config = rig->config;
    board_init(&rig->board, &config);
    assert_close(rig->board.tuning.parameters.values[PARAMETER_K_PITCH], 2.5, 0.0);
    assert_close(rig->board.tuning.gains.autopilot.k_pitch, 2.5, 0.0);
}

static void an_unknown_command_without_payload_gets_through_the_decoder_to_be_answered(void** state)
{
    (void)state;
    uint8_t frame[frame_max_bytes];
    const size_t size = frame_encode(&frame_to_board, 0x1FF, NULL, 0, frame, sizeof frame);
    static line_t line;
    line_init(&line, &board_frames_in);
    line_feed(&line, frame, size, 0);
    assert_int_equal(line.count, 1);
    assert_int_equal(line.frames[0].type_id, 0x1FF);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(after_power_on_the_control_source_is_rc_and_everything_is_off),
        cmocka_unit_test(before_the_station_asks_nothing_is_acknowledged),
        cmocka_unit_test(once_asked_every_command_but_0_and_50_is_acknowledged),
        cmocka_unit_test(a_station_that_opens_the_line_anew_has_to_ask_anew),
        cmocka_unit_test(a_deployed_board_knows_no_extension),
        cmocka_unit_test(the_status_comes_once_a_second),
        cmocka_unit_test(exit_and_reset_are_for_the_application_and_acknowledged_first),
        cmocka_unit_test(streams_that_are_on_are_sent_by_their_task_alone),
        cmocka_unit_test(servo_outputs_follow_the_law_that_was_chosen),
        cmocka_unit_test(stored_parameters_are_there_after_the_next_power_on),
        cmocka_unit_test(an_unknown_command_without_payload_gets_through_the_decoder_to_be_answered),
    };
    return cmocka_run_group_tests_name("flight.board", tests, NULL, NULL);
}
