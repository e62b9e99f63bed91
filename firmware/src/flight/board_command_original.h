/// What the rows of the deployed boards' commands do. Context: a `board_command_context_t`. The second argument is the
/// row's constant: on or off, the stream, the plan, the task, the route, the servos' mode, the parameter's index.
#ifndef FLIGHT_BOARD_COMMAND_ORIGINAL_H
#define FLIGHT_BOARD_COMMAND_ORIGINAL_H

#include <stdint.h>

#include "comms/command.h"

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

#endif
