#include "flight/board_command_original.h"

#include "flight/board_command_context.h"
#include "flight/board_streams.h"

_Static_assert(COMMAND_SERVO_OUT_SERVO_MAXIMUM == board_servo_count - 1, "every output can be commanded");

static command_result_t done_or(bool done, command_result_t otherwise)
{
    return done ? command_done : otherwise;
}

/// Commands that only the application carries out: do nothing, reset, exit.
command_result_t run_do_nothing(void* context, int32_t argument, const uint8_t* payload)
{
    (void)context;
    (void)argument;
    (void)payload;
    return command_done;
}

command_result_t run_switch_all(void* context, int32_t on, const uint8_t* payload)
{
    (void)payload;
    telemetry_switch_all(&board_of(context)->schedule, on != 0);
    return command_done;
}

command_result_t run_read_all(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    (void)payload;
    for (size_t stream = 0; stream < telemetry_stream_count; stream++)
    {
        board_send_stream(board_of(context), (telemetry_stream_t)stream);
    }
    return command_done;
}

command_result_t run_stream_on(void* context, int32_t stream, const uint8_t* payload)
{
    (void)payload;
    telemetry_switch(&board_of(context)->schedule, (telemetry_stream_t)stream, true);
    return command_done;
}

command_result_t run_stream_off(void* context, int32_t stream, const uint8_t* payload)
{
    (void)payload;
    telemetry_switch(&board_of(context)->schedule, (telemetry_stream_t)stream, false);
    return command_done;
}

/// Refused with RC as control source, because then the transmitter's switch decides.
command_result_t run_switch_autopilot(void* context, int32_t on, const uint8_t* payload)
{
    (void)payload;
    board_t* const board = board_of(context);
    if (board->hil.source == control_source_rc)
    {
        return command_bad_state;
    }
    board->hil.autopilot = on != 0;
    return command_done;
}

command_result_t run_switch_autotrim(void* context, int32_t on, const uint8_t* payload)
{
    (void)payload;
    board_t* const board = board_of(context);
    if (board->hil.source == control_source_rc)
    {
        return command_bad_state;
    }
    board->hil.autotrim = on != 0;
    return command_done;
}

command_result_t run_next_waypoint(void* context, int32_t plan, const uint8_t* payload)
{
    (void)payload;
    return done_or(plan_next(&board_of(context)->plans.plan[plan]), command_bad_state);
}

command_result_t run_previous_waypoint(void* context, int32_t plan, const uint8_t* payload)
{
    (void)payload;
    return done_or(plan_previous(&board_of(context)->plans.plan[plan]), command_bad_state);
}

command_result_t run_set_period(void* context, int32_t task, const uint8_t* payload)
{
    const int32_t period_ms = protocol_get_i32(payload);
    return done_or(telemetry_set_period(&board_of(context)->schedule, (telemetry_task_t)task, period_ms),
                   command_bad_value);
}

command_result_t run_take_xplane_info(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    command_xplane_info_t info;
    command_xplane_info_unpack(&info, payload);
    board_t* const board = board_of(context);
    const uint32_t now_ms = ((board_command_context_t*)context)->now_ms;
    const bool is_flown = hil_loop_step(&board->hil, &board->measured, &board->tuning.gains,
                                        &board->plans.plan[board_plan_hil], &info, now_ms);
    // a refused command is answered too, with the newest surfaces, because the simulator waits for an answer
    report_hil_surfaces(&board->line, &board->hil.loop.surfaces);
    if (board->station.wants_steps)
    {
        report_hil_step(&board->line, now_ms, board->hil.step_s);
    }
    return done_or(is_flown, command_bad_value);
}

command_result_t run_load_route(void* context, int32_t number, const uint8_t* payload)
{
    (void)payload;
    return done_or(board_plans_load_route(&board_of(context)->plans, number), command_bad_value);
}

command_result_t run_choose_source(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    board_t* const board = board_of(context);
    const int32_t source = protocol_get_i32(payload);
    if (source != COMMAND_CONTROL_SOURCE_SOURCE_RC && source != COMMAND_CONTROL_SOURCE_SOURCE_JOYSTICK)
    {
        return command_bad_value;
    }
    board->hil.source = (control_source_t)source;
    hil_loop_refresh_switches(&board->hil, &board->measured);
    return command_done;
}

/// Also ends the manual position of every output.
command_result_t run_set_servos_mode(void* context, int32_t mode, const uint8_t* payload)
{
    (void)payload;
    servo_outputs_set_mode(&board_of(context)->servos, (board_servos_mode_t)mode);
    return command_done;
}

command_result_t run_move_servo(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    command_servo_out_t values;
    command_servo_out_unpack(&values, payload);
    return done_or(servo_outputs_move(&board_of(context)->servos, values.servo, values.position), command_bad_value);
}

command_result_t run_load_parameters(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    (void)payload;
    const board_t* const board = board_of(context);
    report_parameters(&board->line, &board->tuning.parameters);
    return command_done;
}

command_result_t run_set_parameter(void* context, int32_t index, const uint8_t* payload)
{
    const float value =
        parameter_definitions[index].is_integer ? (float)protocol_get_i32(payload) : protocol_get_f32(payload);
    return done_or(tuning_set(&board_of(context)->tuning, (size_t)index, value), command_bad_value);
}
