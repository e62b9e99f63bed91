#include "support/cmocka_all.h"

#include "support/rig.h"

static int waypoint_of(const rig_t* rig, size_t plan)
{
    return (int)rig->board.plans.plan[plan].current;
}

static void each_stream_is_switched_by_its_own_pair_and_told_in_the_heartbeat(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    const struct
    {
        uint32_t on;
        uint32_t off;
        size_t offset;
    } pairs[] = {
        {COMMAND_AHRS_ON_ID, COMMAND_AHRS_OFF_ID, offsetof(message_heartbeat_t, ahrs)},
        {COMMAND_INERTIAL_ON_ID, COMMAND_INERTIAL_OFF_ID, offsetof(message_heartbeat_t, inertial)},
        {COMMAND_ANALOG_ON_ID, COMMAND_ANALOG_OFF_ID, offsetof(message_heartbeat_t, analog)},
        {COMMAND_STATISTICS_ON_ID, COMMAND_STATISTICS_OFF_ID, offsetof(message_heartbeat_t, statistics)},
        {COMMAND_GPS_ON_ID, COMMAND_GPS_OFF_ID, offsetof(message_heartbeat_t, gps)},
        {COMMAND_SERVOS_IN_ON_ID, COMMAND_SERVOS_IN_OFF_ID, offsetof(message_heartbeat_t, servos)},
        {COMMAND_FLY_BY_WIRE_ON_ID, COMMAND_FLY_BY_WIRE_OFF_ID, offsetof(message_heartbeat_t, fly_by_wire)},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
    {
        for (int on = 1; on >= 0; on--)
        {
            (void)rig_do(rig, on == 1 ? pairs[i].on : pairs[i].off);
            const message_heartbeat_t heartbeat = rig_heartbeat(rig);
            int flags = 0;
            for (size_t j = 0; j < sizeof heartbeat; j++)
            {
                flags += ((const int8_t*)&heartbeat)[j];
            }
            assert_int_equal(((const int8_t*)&heartbeat)[pairs[i].offset], on);
            assert_int_equal(flags, on);
        }
    }
}

static void start_and_stop_switch_all_streams(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do(rig, COMMAND_START_ID);
    line_clear(&rig->out);
    for (size_t task = 0; task < telemetry_task_count; task++)
    {
        board_send_streams(&rig->board, (telemetry_task_t)task);
    }
    assert_int_equal(rig->out.count, telemetry_stream_count);
    (void)rig_do(rig, COMMAND_STOP_ID);
    for (size_t task = 0; task < telemetry_task_count; task++)
    {
        board_send_streams(&rig->board, (telemetry_task_t)task);
    }
    assert_int_equal(rig->out.count, 1);
    assert_int_equal(rig->out.frames[0].type_id, MESSAGE_HEARTBEAT_ID);
}

static void read_all_sends_every_stream_once_and_switches_none_on(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do(rig, COMMAND_READ_ALL_ID);
    assert_int_equal(rig->out.count, telemetry_stream_count);
    for (uint32_t type_id = MESSAGE_HEARTBEAT_ID; type_id <= MESSAGE_GPS_ID; type_id++)
    {
        assert_int_equal(line_count_of(&rig->out, type_id), 1);
    }
    assert_int_equal(rig_heartbeat(rig).ahrs, 0);
}

static void with_the_joystick_the_buttons_switch_autopilot_and_autotrim(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    assert_int_equal(rig_heartbeat(rig).autopilot_hil, 2);
    (void)rig_do(rig, COMMAND_AUTOPILOT_ON_ID);
    (void)rig_do(rig, COMMAND_AUTOTRIM_ON_ID);
    assert_int_equal(rig_heartbeat(rig).autopilot_hil, 3);
    assert_int_equal(rig_heartbeat(rig).autotrim_hil, 1);
    assert_int_equal(rig_heartbeat(rig).autopilot, 0); // the real aircraft's stays
    (void)rig_do(rig, COMMAND_AUTOPILOT_OFF_ID);
    (void)rig_do(rig, COMMAND_AUTOTRIM_OFF_ID);
    assert_int_equal(rig_heartbeat(rig).autopilot_hil, 2);
    assert_int_equal(rig_heartbeat(rig).autotrim_hil, 0);
}

static void with_rc_the_transmitters_switches_rule_and_the_buttons_are_refused(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    const uint32_t buttons[] = {COMMAND_AUTOPILOT_ON_ID, COMMAND_AUTOPILOT_OFF_ID, COMMAND_AUTOTRIM_ON_ID,
                                COMMAND_AUTOTRIM_OFF_ID};
    for (size_t i = 0; i < sizeof buttons / sizeof buttons[0]; i++)
    {
        assert_int_equal(rig_ask(rig, buttons[i], NULL, 0), command_bad_state);
    }
    assert_int_equal(rig_heartbeat(rig).autopilot_hil, 0);
    rig->board.measured.sensors.servos_in.channel[rc_channel_autopilot] = 1.0F;
    const message_heartbeat_t heartbeat = rig_heartbeat(rig);
    assert_int_equal(heartbeat.autopilot_hil, 1);
    assert_int_equal(heartbeat.autopilot, 1);
    assert_int_equal(heartbeat.auto_switch, 1);
    assert_int_equal(heartbeat.autotrim_hil, 0);
    rig->board.measured.sensors.servos_in.channel[rc_channel_autotrim] = 1.0F;
    assert_int_equal(rig_heartbeat(rig).autotrim_hil, 1);
    assert_int_equal(rig_heartbeat(rig).autotrim, 1);
}

static void a_control_source_that_is_none_is_refused(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with(rig, COMMAND_CONTROL_SOURCE_ID, 2), command_bad_value);
    assert_int_equal(rig_ask_with(rig, COMMAND_CONTROL_SOURCE_ID, -1), command_bad_value);
    assert_int_equal(rig_heartbeat(rig).autopilot_hil, 0);
    assert_int_equal(rig_ask_with(rig, COMMAND_CONTROL_SOURCE_ID, 1), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_CONTROL_SOURCE_ID, 0), command_done);
}

static void the_four_routes_load_into_the_hil_plan(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    const size_t counts[] = {8, 20, 11, 10};
    for (int32_t i = 0; i < 4; i++)
    {
        (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID + (uint32_t)i);
        assert_int_equal(rig->board.plans.plan[board_plan_hil].count, counts[i]);
        assert_int_equal(rig->board.plans.hil_route, i);
    }
    assert_int_equal(rig->board.plans.plan[board_plan_flight].count, 0);
}

static void next_and_previous_move_their_own_plan_and_say_when_they_cannot(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask(rig, COMMAND_HIL_FMS_NEXT_WAYPOINT_ID, NULL, 0), command_bad_state);
    (void)rig_do(rig, COMMAND_HIL_LOAD_VUELO_ID);
    assert_int_equal(rig_ask(rig, COMMAND_HIL_FMS_NEXT_WAYPOINT_ID, NULL, 0), command_done);
    assert_int_equal(waypoint_of(rig, board_plan_hil), 1);
    assert_int_equal(rig_ask(rig, COMMAND_HIL_FMS_PREVIOUS_WAYPOINT_ID, NULL, 0), command_done);
    assert_int_equal(rig_ask(rig, COMMAND_HIL_FMS_PREVIOUS_WAYPOINT_ID, NULL, 0), command_bad_state);
    assert_int_equal(waypoint_of(rig, board_plan_hil), 0);
    assert_int_equal(rig_ask(rig, COMMAND_FMS_NEXT_WAYPOINT_ID, NULL, 0), command_bad_state);
    rig->board.plans.plan[board_plan_flight] = rig->board.plans.plan[board_plan_hil];
    assert_int_equal(rig_ask(rig, COMMAND_FMS_NEXT_WAYPOINT_ID, NULL, 0), command_done);
    assert_int_equal(waypoint_of(rig, board_plan_flight), 1);
    assert_int_equal(rig_ask(rig, COMMAND_FMS_PREVIOUS_WAYPOINT_ID, NULL, 0), command_done);
    assert_int_equal(waypoint_of(rig, board_plan_hil), 0);
}

static void rates_of_the_three_tasks_are_set_within_their_ranges(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with(rig, COMMAND_SET_PARAMETER_TASK_RATE_ID, 250), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_SET_FMS_TASK_RATE_ID, 350), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_SET_SERVOS_TASK_RATE_ID, 450), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_SET_FMS_TASK_RATE_ID, 49), command_bad_value);
    assert_int_equal(rig->board.schedule.period_ms[telemetry_task_param], 250);
    assert_int_equal(rig->board.schedule.period_ms[telemetry_task_fms], 350);
    assert_int_equal(rig->board.schedule.period_ms[telemetry_task_servos], 450);
}

static int move(rig_t* rig, int32_t servo, float position)
{
    const command_servo_out_t values = {.servo = servo, .position = position};
    uint8_t payload[COMMAND_SERVO_OUT_SIZE];
    command_servo_out_pack(&values, payload);
    return rig_ask(rig, COMMAND_SERVO_OUT_ID, payload, sizeof payload);
}

static void a_servo_moves_where_it_is_told_and_nowhere_else(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(move(rig, 19, -0.75F), command_done);
    assert_int_equal(move(rig, rc_channel_elevator, 0.5F), command_done);
    assert_int_equal(move(rig, 20, 0.0F), command_bad_value);
    assert_int_equal(move(rig, -1, 0.0F), command_bad_value);
    assert_int_equal(move(rig, 5, 1.01F), command_bad_value);
    assert_int_equal(move(rig, 5, NAN), command_bad_value);
    float positions[board_servo_count];
    board_servo_positions(&rig->board, positions);
    assert_close(positions[19], -0.75, 0.0);
    assert_close(positions[rc_channel_elevator], 0.5, 0.0);
    assert_close(positions[5], 0.0, 0.0);
    // a chosen mode hands the outputs back to their law
    (void)rig_do(rig, COMMAND_SERVOS_CONTROL_MODE_FLY_BY_WIRE_ID);
    board_servo_positions(&rig->board, positions);
    assert_close(positions[rc_channel_elevator], 0.0, 0.0);
    assert_close(positions[19], -0.75, 0.0);
}

static void a_parameter_is_set_read_back_and_used_at_once(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_parameter(rig, COMMAND_SET_K_HEADING_ID, 1.25F), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_SET_K_DIV_VELOCIDAD_ID, 900), command_done);
    (void)rig_do(rig, COMMAND_LOAD_AUTOPILOT_PARAMETERS_ID);
    message_autopilot_parameters_t values;
    message_autopilot_parameters_unpack(&values, line_newest(&rig->out, MESSAGE_AUTOPILOT_PARAMETERS_ID)->payload);
    assert_close(values.k_heading, 1.25, 0.0);
    assert_int_equal(values.k_div_velocidad, 900);
    assert_close(values.k_rudder, 1.0, 0.0);
    assert_close(rig->board.tuning.gains.autopilot.k_heading, 1.25, 0.0);
    assert_close(rig->board.tuning.gains.autopilot.k_div_speed_kt_s, 900.0, 0.0);
}

static void a_parameter_out_of_its_range_is_refused_and_keeps_its_value(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_parameter(rig, COMMAND_SET_K_ROLL_ID, 100.0F), command_bad_value);
    assert_int_equal(rig_ask_parameter(rig, COMMAND_SET_K_ROLL_ID, NAN), command_bad_value);
    assert_int_equal(rig_ask_with(rig, COMMAND_SET_K_DIV_VELOCIDAD_ID, 9), command_bad_value);
    assert_close(rig->board.tuning.gains.autopilot.k_roll, 2.0, 0.0);
    assert_close(rig->board.tuning.gains.autopilot.k_div_speed_kt_s, 700.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_stream_is_switched_by_its_own_pair_and_told_in_the_heartbeat),
        cmocka_unit_test(start_and_stop_switch_all_streams),
        cmocka_unit_test(read_all_sends_every_stream_once_and_switches_none_on),
        cmocka_unit_test(with_the_joystick_the_buttons_switch_autopilot_and_autotrim),
        cmocka_unit_test(with_rc_the_transmitters_switches_rule_and_the_buttons_are_refused),
        cmocka_unit_test(a_control_source_that_is_none_is_refused),
        cmocka_unit_test(the_four_routes_load_into_the_hil_plan),
        cmocka_unit_test(next_and_previous_move_their_own_plan_and_say_when_they_cannot),
        cmocka_unit_test(rates_of_the_three_tasks_are_set_within_their_ranges),
        cmocka_unit_test(a_servo_moves_where_it_is_told_and_nowhere_else),
        cmocka_unit_test(a_parameter_is_set_read_back_and_used_at_once),
        cmocka_unit_test(a_parameter_out_of_its_range_is_refused_and_keeps_its_value),
    };
    return cmocka_run_group_tests_name("flight.board_command_original", tests, NULL, NULL);
}
