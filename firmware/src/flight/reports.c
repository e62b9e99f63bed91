#include "flight/reports.h"

#include <math.h>

#include "comms/frame.h"

static void send(const report_line_t* line, uint32_t type_id, const uint8_t* payload, size_t size)
{
    uint8_t frame[frame_max_bytes];
    const size_t length = frame_encode(&frame_from_board, type_id, payload, size, frame, sizeof frame);
    line->send(line->context, frame, length);
}

void report_heartbeat(const report_line_t* line, const message_heartbeat_t* values)
{
    uint8_t payload[MESSAGE_HEARTBEAT_SIZE];
    message_heartbeat_pack(values, payload);
    send(line, MESSAGE_HEARTBEAT_ID, payload, sizeof payload);
}

void report_ahrs(const report_line_t* line, const message_ahrs_t* values)
{
    uint8_t payload[MESSAGE_AHRS_SIZE];
    message_ahrs_pack(values, payload);
    send(line, MESSAGE_AHRS_ID, payload, sizeof payload);
}

void report_inertial(const report_line_t* line, const message_inertial_t* values)
{
    uint8_t payload[MESSAGE_INERTIAL_SIZE];
    message_inertial_pack(values, payload);
    send(line, MESSAGE_INERTIAL_ID, payload, sizeof payload);
}

void report_analog(const report_line_t* line, const message_analog_t* values)
{
    uint8_t payload[MESSAGE_ANALOG_SIZE];
    message_analog_pack(values, payload);
    send(line, MESSAGE_ANALOG_ID, payload, sizeof payload);
}

void report_statistics(const report_line_t* line, const message_statistics_t* values)
{
    uint8_t payload[MESSAGE_STATISTICS_SIZE];
    message_statistics_pack(values, payload);
    send(line, MESSAGE_STATISTICS_ID, payload, sizeof payload);
}

void report_gps(const report_line_t* line, const message_gps_t* values)
{
    uint8_t payload[MESSAGE_GPS_SIZE];
    message_gps_pack(values, payload);
    send(line, MESSAGE_GPS_ID, payload, sizeof payload);
}

void report_servos_in(const report_line_t* line, const message_servos_in_t* values)
{
    uint8_t payload[MESSAGE_SERVOS_IN_SIZE];
    message_servos_in_pack(values, payload);
    send(line, MESSAGE_SERVOS_IN_ID, payload, sizeof payload);
}

void report_capabilities(const report_line_t* line, const message_capabilities_t* values)
{
    uint8_t payload[MESSAGE_CAPABILITIES_SIZE];
    message_capabilities_pack(values, payload);
    send(line, MESSAGE_CAPABILITIES_ID, payload, sizeof payload);
}

void report_status(const report_line_t* line, const message_board_status_t* values)
{
    uint8_t payload[MESSAGE_BOARD_STATUS_SIZE];
    message_board_status_pack(values, payload);
    send(line, MESSAGE_BOARD_STATUS_ID, payload, sizeof payload);
}

/// What a plan asks for. Zeros would read as a course to the north at sea level, so unknown values are sent as absent:
/// all of them without a plan, the way to the waypoint without a position.
static message_fms_plan_t plan_values(const plan_t* plan, const position_t* position, float speed_kt)
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
    if (plan_guidance(plan, position, speed_kt, &guidance))
    {
        values.bearing_deg = guidance.bearing_deg;
        values.distance_m = (int32_t)lroundf(guidance.distance_m);
    }
    return values;
}

void report_plan(const report_line_t* line, uint32_t type_id, const plan_t* plan, const position_t* position,
                 float speed_kt)
{
    const message_fms_plan_t values = plan_values(plan, position, speed_kt);
    uint8_t payload[MESSAGE_FMS_PLAN_SIZE];
    message_fms_plan_pack(&values, payload);
    send(line, type_id, payload, sizeof payload);
}

void report_fly_by_wire(const report_line_t* line, const surfaces_t* surfaces)
{
    const message_fly_by_wire_t values = {
        .aileron = surfaces->aileron,
        .throttle = surfaces->throttle,
        .elevator = surfaces->elevator,
        .rudder = surfaces->rudder,
    };
    uint8_t payload[MESSAGE_FLY_BY_WIRE_SIZE];
    message_fly_by_wire_pack(&values, payload);
    send(line, MESSAGE_FLY_BY_WIRE_ID, payload, sizeof payload);
}

void report_hil_surfaces(const report_line_t* line, const surfaces_t* surfaces)
{
    const message_hil_surfaces_t values = {
        .elevator = surfaces->elevator,
        .aileron = surfaces->aileron,
        .rudder = surfaces->rudder,
        .throttle = surfaces->throttle,
    };
    uint8_t payload[MESSAGE_HIL_SURFACES_SIZE];
    message_hil_surfaces_pack(&values, payload);
    send(line, MESSAGE_HIL_SURFACES_ID, payload, sizeof payload);
}

void report_parameters(const report_line_t* line, const parameters_t* parameters)
{
    uint8_t payload[MESSAGE_AUTOPILOT_PARAMETERS_SIZE];
    for (size_t i = 0; i < parameters_count; i++)
    {
        const float value = parameters->values[i];
        if (parameter_definitions[i].is_integer)
        {
            protocol_put_i32(payload + 4 * i, (int32_t)lroundf(value));
        }
        else
        {
            protocol_put_f32(payload + 4 * i, value);
        }
    }
    send(line, MESSAGE_AUTOPILOT_PARAMETERS_ID, payload, sizeof payload);
}

void report_acknowledgement(const report_line_t* line, uint32_t type_id, command_result_t result)
{
    const message_acknowledgement_t values = {.command_type = (int32_t)type_id, .result = (int32_t)result};
    uint8_t payload[MESSAGE_ACKNOWLEDGEMENT_SIZE];
    message_acknowledgement_pack(&values, payload);
    send(line, MESSAGE_ACKNOWLEDGEMENT_ID, payload, sizeof payload);
}

void report_mission_count(const report_line_t* line, int32_t plan, size_t count)
{
    const message_mission_count_t values = {.plan = plan, .count = (int32_t)count};
    uint8_t payload[MESSAGE_MISSION_COUNT_SIZE];
    message_mission_count_pack(&values, payload);
    send(line, MESSAGE_MISSION_COUNT_ID, payload, sizeof payload);
}

void report_mission_item(const report_line_t* line, int32_t plan, size_t index, const waypoint_t* waypoint)
{
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
    send(line, MESSAGE_MISSION_ITEM_ID, payload, sizeof payload);
}
