#include "flight/board_commands.h"

#include "comms/protocol_gen.h"
#include "comms/telemetry.h"
#include "flight/board_command_extensions.h"
#include "flight/board_command_original.h"
#include "flight/board_plans.h"
#include "flight/servo_outputs.h"
#include "navigation/routes_gen.h"
#include "params/parameters_gen.h"

/// Rows of commands without a constant, with a constant, and of those that set a parameter.
#define ROW(name, run) {COMMAND_##name##_ID, COMMAND_##name##_SIZE, run, 0}
#define ROW_WITH(name, run, argument) {COMMAND_##name##_ID, COMMAND_##name##_SIZE, run, (int32_t)(argument)}
#define ROW_PARAMETER(name) ROW_WITH(SET_##name, run_set_parameter, PARAMETER_##name)

const command_t board_commands[] = {
    ROW(DO_NOTHING, run_do_nothing),
    ROW_WITH(STOP, run_switch_all, false),
    ROW_WITH(START, run_switch_all, true),
    ROW(READ_ALL, run_read_all),
    ROW(RESET, run_do_nothing),
    ROW_WITH(AHRS_ON, run_stream_on, telemetry_ahrs),
    ROW_WITH(AHRS_OFF, run_stream_off, telemetry_ahrs),
    ROW_WITH(INERTIAL_ON, run_stream_on, telemetry_inertial),
    ROW_WITH(INERTIAL_OFF, run_stream_off, telemetry_inertial),
    ROW_WITH(ANALOG_ON, run_stream_on, telemetry_analog),
    ROW_WITH(ANALOG_OFF, run_stream_off, telemetry_analog),
    ROW_WITH(STATISTICS_ON, run_stream_on, telemetry_statistics),
    ROW_WITH(STATISTICS_OFF, run_stream_off, telemetry_statistics),
    ROW_WITH(GPS_ON, run_stream_on, telemetry_gps),
    ROW_WITH(GPS_OFF, run_stream_off, telemetry_gps),
    ROW_WITH(SERVOS_IN_ON, run_stream_on, telemetry_servos_in),
    ROW_WITH(SERVOS_IN_OFF, run_stream_off, telemetry_servos_in),
    ROW_WITH(FLY_BY_WIRE_ON, run_stream_on, telemetry_fly_by_wire),
    ROW_WITH(FLY_BY_WIRE_OFF, run_stream_off, telemetry_fly_by_wire),
    ROW_WITH(FMS_PLAN_ON, run_stream_on, telemetry_fms_plan),
    ROW_WITH(FMS_PLAN_OFF, run_stream_off, telemetry_fms_plan),
    ROW_WITH(FMS_HIL_PLAN_ON, run_stream_on, telemetry_fms_hil_plan),
    ROW_WITH(FMS_HIL_PLAN_OFF, run_stream_off, telemetry_fms_hil_plan),
    ROW_WITH(AUTOPILOT_ON, run_switch_autopilot, true),
    ROW_WITH(AUTOPILOT_OFF, run_switch_autopilot, false),
    ROW_WITH(AUTOTRIM_ON, run_switch_autotrim, true),
    ROW_WITH(AUTOTRIM_OFF, run_switch_autotrim, false),
    ROW_WITH(FMS_NEXT_WAYPOINT, run_next_waypoint, board_plan_flight),
    ROW_WITH(FMS_PREVIOUS_WAYPOINT, run_previous_waypoint, board_plan_flight),
    ROW_WITH(HIL_FMS_NEXT_WAYPOINT, run_next_waypoint, board_plan_hil),
    ROW_WITH(HIL_FMS_PREVIOUS_WAYPOINT, run_previous_waypoint, board_plan_hil),
    ROW_WITH(SET_PARAMETER_TASK_RATE, run_set_period, telemetry_task_param),
    ROW_WITH(SET_FMS_TASK_RATE, run_set_period, telemetry_task_fms),
    ROW_WITH(SET_SERVOS_TASK_RATE, run_set_period, telemetry_task_servos),
    ROW(EXIT_BINARY_MODE, run_do_nothing),
    ROW(XPLANE_INFO, run_take_xplane_info),
    ROW_WITH(HIL_LOAD_GANDO, run_load_route, ROUTE_GANDO),
    ROW_WITH(HIL_LOAD_RUTA_ISLA, run_load_route, ROUTE_RUTA_ISLA),
    ROW_WITH(HIL_LOAD_ALTERNATIVA, run_load_route, ROUTE_ALTERNATIVA),
    ROW_WITH(HIL_LOAD_VUELO, run_load_route, ROUTE_VUELO),
    ROW(CONTROL_SOURCE, run_choose_source),
    ROW_WITH(SERVOS_CONTROL_MODE_FLY_BY_WIRE, run_set_servos_mode, board_servos_fly_by_wire),
    ROW_WITH(SERVOS_CONTROL_MODE_HIL, run_set_servos_mode, board_servos_hil),
    ROW(SERVO_OUT, run_move_servo),
    ROW(LOAD_AUTOPILOT_PARAMETERS, run_load_parameters),
    ROW_PARAMETER(K_ELEV),
    ROW_PARAMETER(K_AIRLN),
    ROW_PARAMETER(K_RUDDER),
    ROW_PARAMETER(K_INT_PITCH),
    ROW_PARAMETER(K_DIV_P_INIT),
    ROW_PARAMETER(K_DIV_P_SPEED),
    ROW_PARAMETER(K_DIV_Q_INIT),
    ROW_PARAMETER(K_DIV_Q_SPEED),
    ROW_PARAMETER(K_DIV_R_INIT),
    ROW_PARAMETER(K_DIV_R_SPEED),
    ROW_PARAMETER(K_DIV_VELOCIDAD),
    ROW_PARAMETER(K_ROLL),
    ROW_PARAMETER(K_HEADING),
    ROW_PARAMETER(K_PITCH),
    ROW_PARAMETER(K_VVI),
    ROW_PARAMETER(K_ALTURA),
    ROW_PARAMETER(K_INT_ALTURA),
    ROW(CAPABILITIES, run_tell_capabilities),
    ROW(STORE_PARAMETERS, run_store_parameters),
    ROW(SELECT_AIRSPEED_SOURCE, run_select_airspeed),
    ROW(SELECT_ALTITUDE_SOURCE, run_select_altitude),
    ROW(MISSION_BEGIN, run_begin_mission),
    ROW(MISSION_ITEM, run_take_mission_item),
    ROW(MISSION_COMMIT, run_commit_mission),
    ROW(MISSION_READ, run_read_mission),
    ROW(GO_TO_WAYPOINT, run_go_to_waypoint),
    ROW(HIL_STEPS_ON, run_tell_steps),
    ROW(DESCRIBE, run_describe),
    ROW(DESCRIBE_BLOCKS, run_describe_blocks),
    ROW(OWN_GAIN_GET, run_get_own_gain),
    ROW(OWN_GAIN_SET, run_set_own_gain),
    ROW(OWN_TOPICS, run_switch_own_topics),
};

const size_t board_commands_count = sizeof board_commands / sizeof board_commands[0];
