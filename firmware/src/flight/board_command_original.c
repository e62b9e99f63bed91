#include "flight/board_command_functions.h"

#include <string.h>

#include "flight/board_loops.h"
#include "flight/board_reports.h"
#include "flight/gains.h"
#include "navigation/routes_gen.h"

_Static_assert(COMMAND_SERVO_OUT_SERVO_MAXIMUM == board_servo_count - 1, "every output can be commanded");

static command_result_t done_or(bool done, command_result_t otherwise)
{
    return done ? command_done : otherwise;
}

/// Commands whose whole effect is the application's: do nothing, reset, exit.
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
        board_report_stream(board_of(context), (telemetry_stream_t)stream);
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

/// With RC as control source the transmitter's switch is the one that counts.
command_result_t run_switch_autopilot(void* context, int32_t on, const uint8_t* payload)
{
    (void)payload;
    board_t* const board = board_of(context);
    if (board->source == board_source_rc)
    {
        return command_bad_state;
    }
    board->hil_autopilot = on != 0;
    return command_done;
}

command_result_t run_switch_autotrim(void* context, int32_t on, const uint8_t* payload)
{
    (void)payload;
    board_t* const board = board_of(context);
    if (board->source == board_source_rc)
    {
        return command_bad_state;
    }
    board->hil_autotrim = on != 0;
    return command_done;
}

command_result_t run_next_waypoint(void* context, int32_t plan, const uint8_t* payload)
{
    (void)payload;
    return done_or(plan_next(&board_of(context)->plans[plan]), command_bad_state);
}

command_result_t run_previous_waypoint(void* context, int32_t plan, const uint8_t* payload)
{
    (void)payload;
    return done_or(plan_previous(&board_of(context)->plans[plan]), command_bad_state);
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
    return board_hil_step(board_of(context), &info, ((board_command_context_t*)context)->now_ms);
}

command_result_t run_load_route(void* context, int32_t number, const uint8_t* payload)
{
    (void)payload;
    board_t* const board = board_of(context);
    const route_t* const route = &routes[number];
    waypoint_t waypoints[ROUTE_WAYPOINTS_MAX];
    for (size_t i = 0; i < route->count; i++)
    {
        waypoints[i] = (waypoint_t){
            .position = {route->waypoints[i].latitude_deg, route->waypoints[i].longitude_deg},
            .altitude_ft = route->waypoints[i].altitude_ft,
            .speed_kt = route->waypoints[i].speed_kt,
        };
    }
    if (!plan_replace(&board->plans[board_plan_hil], waypoints, route->count, route->loop))
    {
        return command_bad_value;
    }
    board->hil_plan_name = number;
    board->plan_is_to_store[board_plan_hil] = false; // what is uploaded is kept, not a route that the board knows
    board->reading_plan = -1;
    return command_done;
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
    board->source = (board_source_t)source;
    board_refresh_switches(board);
    return command_done;
}

/// A change of mode also hands outputs that were moved by hand back to their law.
command_result_t run_set_servos_mode(void* context, int32_t mode, const uint8_t* payload)
{
    (void)payload;
    board_t* const board = board_of(context);
    board->servos_mode = (board_servos_mode_t)mode;
    memset(board->servo_is_commanded, 0, sizeof board->servo_is_commanded);
    return command_done;
}

command_result_t run_move_servo(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    board_t* const board = board_of(context);
    command_servo_out_t values;
    command_servo_out_unpack(&values, payload);
    // written so that a NaN fails
    const bool allowed =
        values.servo >= 0 && values.servo < board_servo_count && values.position >= -1.0F && values.position <= 1.0F;
    if (!allowed)
    {
        return command_bad_value;
    }
    board->servo_out[values.servo] = values.position;
    board->servo_is_commanded[values.servo] = true;
    return command_done;
}

command_result_t run_load_parameters(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    (void)payload;
    board_report_parameters(board_of(context));
    return command_done;
}

command_result_t run_set_parameter(void* context, int32_t index, const uint8_t* payload)
{
    board_t* const board = board_of(context);
    const float value =
        parameter_definitions[index].is_integer ? (float)protocol_get_i32(payload) : protocol_get_f32(payload);
    if (!parameters_set(&board->parameters, (size_t)index, value))
    {
        return command_bad_value;
    }
    board->gains = gains_of(&board->parameters);
    return command_done;
}
