/// What the rows of the command table do. Context is a `board_command_context_t`; `argument` is the row's constant.
#ifndef FLIGHT_BOARD_COMMAND_FUNCTIONS_H
#define FLIGHT_BOARD_COMMAND_FUNCTIONS_H

#include "flight/board_commands.h"

/// The board that a row of the table works on.
static inline board_t* board_of(void* context)
{
    return ((board_command_context_t*)context)->board;
}

// Commands of deployed boards. Argument: on or off, the stream, the plan, the task, the route, the servos' mode, the
// parameter's place in the table.
command_result_t run_do_nothing(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_switch_all(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_read_all(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_stream_on(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_stream_off(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_switch_autopilot(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_switch_autotrim(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_next_waypoint(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_previous_waypoint(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_set_period(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_take_xplane_info(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_load_route(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_choose_source(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_set_servos_mode(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_move_servo(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_load_parameters(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_set_parameter(void* context, int32_t argument, const uint8_t* payload);

// Extensions. No argument.
command_result_t run_tell_capabilities(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_store_parameters(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_select_airspeed(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_select_altitude(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_begin_mission(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_take_mission_item(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_commit_mission(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_read_mission(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_go_to_waypoint(void* context, int32_t argument, const uint8_t* payload);

#endif
