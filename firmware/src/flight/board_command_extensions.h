/// What the rows of the extensions' commands do. Context: a `board_command_context_t`; the rows have no constant.
#ifndef FLIGHT_BOARD_COMMAND_EXTENSIONS_H
#define FLIGHT_BOARD_COMMAND_EXTENSIONS_H

#include <stdint.h>

#include "comms/command.h"

command_result_t run_tell_capabilities(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_tell_steps(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_describe(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_describe_blocks(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_switch_own_topics(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_get_own_gain(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_set_own_gain(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_store_parameters(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_select_airspeed(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_select_altitude(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_begin_mission(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_take_mission_item(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_commit_mission(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_read_mission(void* context, int32_t argument, const uint8_t* payload);
command_result_t run_go_to_waypoint(void* context, int32_t argument, const uint8_t* payload);

#endif
