#include "flight/board_reports.h"

#include <math.h>
#include <string.h>

#include "flight/board_card.h"
#include "flight/board_loops.h"

static void send(board_t* board, uint32_t type_id, const uint8_t* payload, size_t size)
{
    uint8_t frame[frame_max_bytes];
    const size_t length = frame_encode(&frame_from_board, type_id, payload, size, frame, sizeof frame);
    board->config.send(board->config.send_context, frame, length);
}

static int8_t flag(bool on)
{
    return on ? 1 : 0;
}

static void send_heartbeat(board_t* board)
{
    board_refresh_switches(board);
    const bool* const on = board->schedule.on;
    const int hil = (board->hil_autopilot ? MESSAGE_HEARTBEAT_BIT_AUTOPILOT_HIL : 0) |
                    (board->source == board_source_joystick ? MESSAGE_HEARTBEAT_BIT_SOURCE_JOYSTICK : 0);
    const message_heartbeat_t values = {
        .autopilot = flag(board_flight_autopilot(board)),
        .autotrim = flag(board_flight_autotrim(board)),
        .auto_switch = flag(board_flight_autopilot(board)),
        .servos = flag(on[telemetry_servos_in]),
        .gps = flag(on[telemetry_gps]),
        .statistics = flag(on[telemetry_statistics]),
        .ahrs = flag(on[telemetry_ahrs]),
        .inertial = flag(on[telemetry_inertial]),
        .analog = flag(on[telemetry_analog]),
        .fly_by_wire = flag(on[telemetry_fly_by_wire]),
        .autopilot_hil = (int8_t)hil,
        .autotrim_hil = flag(board->hil_autotrim),
    };
    uint8_t payload[MESSAGE_HEARTBEAT_SIZE];
    message_heartbeat_pack(&values, payload);
    send(board, MESSAGE_HEARTBEAT_ID, payload, sizeof payload);
}

static void send_ahrs(board_t* board)
{
    uint8_t payload[MESSAGE_AHRS_SIZE];
    message_ahrs_pack(&board->sensors.ahrs, payload);
    send(board, MESSAGE_AHRS_ID, payload, sizeof payload);
}

static void send_inertial(board_t* board)
{
    uint8_t payload[MESSAGE_INERTIAL_SIZE];
    message_inertial_pack(&board->sensors.inertial, payload);
    send(board, MESSAGE_INERTIAL_ID, payload, sizeof payload);
}

static void send_analog(board_t* board)
{
    uint8_t payload[MESSAGE_ANALOG_SIZE];
    message_analog_pack(&board->sensors.analog, payload);
    send(board, MESSAGE_ANALOG_ID, payload, sizeof payload);
}

/// What a plan asks for. Zeros would read as a course to the north at sea level, so what is not known is absent: all
/// of it without a plan, the way to the waypoint without a position.
static message_fms_plan_t plan_values(const plan_t* plan, const control_loop_input_t* input)
{
    message_fms_plan_t values = {
        .bearing_deg = NAN,
        .altitude_ft = NAN,
        .speed_kt = NAN,
        .distance_m = MESSAGE_FMS_PLAN_DISTANCE_M_ABSENT,
        .waypoint = MESSAGE_FMS_PLAN_WAYPOINT_ABSENT,
    };
    if (plan->count > 0)
    {
        values.altitude_ft = plan->waypoints[plan->current].altitude_ft;
        values.speed_kt = plan->waypoints[plan->current].speed_kt;
        values.waypoint = (int32_t)plan->current;
    }
    plan_guidance_t guidance;
    if (plan_guidance(plan, &input->position, input->speed_kt, &guidance))
    {
        values.bearing_deg = guidance.bearing_deg;
        values.distance_m = (int32_t)lroundf(guidance.distance_m);
    }
    return values;
}

static void send_plan(board_t* board, size_t plan, uint32_t type_id)
{
    const control_loop_input_t input = plan == board_plan_hil ? board_hil_input(board) : board_flight_input(board);
    const message_fms_plan_t values = plan_values(&board->plans[plan], &input);
    uint8_t payload[MESSAGE_FMS_PLAN_SIZE];
    message_fms_plan_pack(&values, payload);
    send(board, type_id, payload, sizeof payload);
}

static void send_flight_plan(board_t* board)
{
    send_plan(board, board_plan_flight, MESSAGE_FMS_PLAN_ID);
}

static void send_hil_plan(board_t* board)
{
    // types 6 and 7 have one layout
    send_plan(board, board_plan_hil, MESSAGE_FMS_HIL_PLAN_ID);
}

static void send_statistics(board_t* board)
{
    uint8_t payload[MESSAGE_STATISTICS_SIZE];
    message_statistics_pack(&board->sensors.statistics, payload);
    send(board, MESSAGE_STATISTICS_ID, payload, sizeof payload);
}

static void send_gps(board_t* board)
{
    uint8_t payload[MESSAGE_GPS_SIZE];
    message_gps_pack(&board->sensors.gps, payload);
    send(board, MESSAGE_GPS_ID, payload, sizeof payload);
}

static void send_servos_in(board_t* board)
{
    uint8_t payload[MESSAGE_SERVOS_IN_SIZE];
    message_servos_in_pack(&board->sensors.servos_in, payload);
    send(board, MESSAGE_SERVOS_IN_ID, payload, sizeof payload);
}

static void send_fly_by_wire(board_t* board)
{
    const surfaces_t* const surfaces = &board->loops[board_plan_flight].surfaces;
    const message_fly_by_wire_t values = {
        .aileron = surfaces->aileron,
        .throttle = surfaces->throttle,
        .elevator = surfaces->elevator,
        .rudder = surfaces->rudder,
    };
    uint8_t payload[MESSAGE_FLY_BY_WIRE_SIZE];
    message_fly_by_wire_pack(&values, payload);
    send(board, MESSAGE_FLY_BY_WIRE_ID, payload, sizeof payload);
}

void board_report_stream(board_t* board, telemetry_stream_t stream)
{
    static void (*const senders[telemetry_stream_count])(board_t*) = {
        [telemetry_heartbeat] = send_heartbeat,   [telemetry_ahrs] = send_ahrs,
        [telemetry_inertial] = send_inertial,     [telemetry_analog] = send_analog,
        [telemetry_fms_plan] = send_flight_plan,  [telemetry_fms_hil_plan] = send_hil_plan,
        [telemetry_statistics] = send_statistics, [telemetry_gps] = send_gps,
        [telemetry_servos_in] = send_servos_in,   [telemetry_fly_by_wire] = send_fly_by_wire,
    };
    senders[stream](board);
}

void board_report_surfaces(board_t* board, const surfaces_t* surfaces)
{
    const message_hil_surfaces_t values = {
        .elevator = surfaces->elevator,
        .aileron = surfaces->aileron,
        .rudder = surfaces->rudder,
        .throttle = surfaces->throttle,
    };
    uint8_t payload[MESSAGE_HIL_SURFACES_SIZE];
    message_hil_surfaces_pack(&values, payload);
    send(board, MESSAGE_HIL_SURFACES_ID, payload, sizeof payload);
}

void board_report_parameters(board_t* board)
{
    uint8_t payload[MESSAGE_AUTOPILOT_PARAMETERS_SIZE];
    for (size_t i = 0; i < parameters_count; i++)
    {
        const float value = board->parameters.values[i];
        if (parameter_definitions[i].is_integer)
        {
            protocol_put_i32(payload + 4 * i, (int32_t)lroundf(value));
        }
        else
        {
            protocol_put_f32(payload + 4 * i, value);
        }
    }
    send(board, MESSAGE_AUTOPILOT_PARAMETERS_ID, payload, sizeof payload);
}

void board_report_capabilities(board_t* board, uint32_t now_ms)
{
    const uint32_t uptime_ms = now_ms & 0x7FFFFFFFU;
    message_capabilities_t values = {
        .protocol_version = 1,
        .features = MESSAGE_CAPABILITIES_BIT_HAS_ACKNOWLEDGEMENTS | MESSAGE_CAPABILITIES_BIT_HAS_SOURCES |
                    MESSAGE_CAPABILITIES_BIT_HAS_MISSIONS,
        .firmware_name = BOARD_FIRMWARE_NAME,
        .firmware_version = BOARD_FIRMWARE_VERSION,
        .uptime_ms = (int32_t)uptime_ms,
    };
    if (board->config.storage != NULL)
    {
        values.features |= MESSAGE_CAPABILITIES_BIT_HAS_STORE;
    }
    if (board_card_alarms(board))
    {
        values.features |= MESSAGE_CAPABILITIES_BIT_HAS_CARD_ALARM;
    }
    uint8_t payload[MESSAGE_CAPABILITIES_SIZE];
    message_capabilities_pack(&values, payload);
    send(board, MESSAGE_CAPABILITIES_ID, payload, sizeof payload);
}

void board_report_acknowledgement(board_t* board, uint32_t type_id, command_result_t result)
{
    const message_acknowledgement_t values = {.command_type = (int32_t)type_id, .result = (int32_t)result};
    uint8_t payload[MESSAGE_ACKNOWLEDGEMENT_SIZE];
    message_acknowledgement_pack(&values, payload);
    send(board, MESSAGE_ACKNOWLEDGEMENT_ID, payload, sizeof payload);
}

void board_report_status(board_t* board)
{
    const message_board_status_t values = {
        .airspeed_source = board->airspeed_source,
        .altitude_source = board->altitude_source,
        .servos_control_mode = (int32_t)board->servos_mode,
        .hil_plan_name = board->hil_plan_name,
        .frames_received = board->frames_received,
        .frames_rejected = board->frames_rejected,
    };
    uint8_t payload[MESSAGE_BOARD_STATUS_SIZE];
    message_board_status_pack(&values, payload);
    send(board, MESSAGE_BOARD_STATUS_ID, payload, sizeof payload);
}

void board_report_mission_count(board_t* board, int32_t plan)
{
    const message_mission_count_t values = {.plan = plan, .count = (int32_t)board->plans[plan].count};
    uint8_t payload[MESSAGE_MISSION_COUNT_SIZE];
    message_mission_count_pack(&values, payload);
    send(board, MESSAGE_MISSION_COUNT_ID, payload, sizeof payload);
}

void board_report_mission_item(board_t* board, int32_t plan, size_t index)
{
    const waypoint_t* const waypoint = &board->plans[plan].waypoints[index];
    const message_mission_item_t values = {
        .plan = plan,
        .index = (int32_t)index,
        .latitude_deg = waypoint->position.latitude_deg,
        .longitude_deg = waypoint->position.longitude_deg,
        .altitude_ft = waypoint->altitude_ft,
        .speed_kt = waypoint->speed_kt,
    };
    uint8_t payload[MESSAGE_MISSION_ITEM_SIZE];
    message_mission_item_pack(&values, payload);
    send(board, MESSAGE_MISSION_ITEM_ID, payload, sizeof payload);
}
