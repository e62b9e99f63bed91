#include "flight/reports.h"

#include <math.h>
#include <string.h>

#include "comms/frame.h"

static void send(const report_line_t* line, uint32_t type_id, const uint8_t* payload, size_t size)
{
    uint8_t frame[frame_max_bytes];
    const size_t length = frame_encode(&frame_from_board, type_id, payload, size, frame, sizeof frame);
    line->send(line->context, frame, length);
}

/// Defines `function`, which packs one message and sends it as a frame.
#define REPORT(function, message, MESSAGE)                                                                             \
    void function(const report_line_t* line, const message##_t* values)                                                \
    {                                                                                                                  \
        uint8_t payload[MESSAGE##_SIZE];                                                                               \
        message##_pack(values, payload);                                                                               \
        send(line, MESSAGE##_ID, payload, sizeof payload);                                                             \
    }

/// A report that only this file calls.
#define REPORT_HERE(function, message, MESSAGE) static REPORT(function, message, MESSAGE)

REPORT(report_heartbeat, message_heartbeat, MESSAGE_HEARTBEAT)
REPORT(report_ahrs, message_ahrs, MESSAGE_AHRS)
REPORT(report_inertial, message_inertial, MESSAGE_INERTIAL)
REPORT(report_analog, message_analog, MESSAGE_ANALOG)
REPORT(report_statistics, message_statistics, MESSAGE_STATISTICS)
REPORT(report_gps, message_gps, MESSAGE_GPS)
REPORT(report_servos_in, message_servos_in, MESSAGE_SERVOS_IN)
REPORT(report_capabilities, message_capabilities, MESSAGE_CAPABILITIES)
REPORT(report_status, message_board_status, MESSAGE_BOARD_STATUS)
REPORT_HERE(send_fly_by_wire, message_fly_by_wire, MESSAGE_FLY_BY_WIRE)
REPORT_HERE(send_hil_surfaces, message_hil_surfaces, MESSAGE_HIL_SURFACES)
REPORT_HERE(send_acknowledgement, message_acknowledgement, MESSAGE_ACKNOWLEDGEMENT)
REPORT_HERE(send_mission_count, message_mission_count, MESSAGE_MISSION_COUNT)
REPORT_HERE(send_hil_step, message_hil_step, MESSAGE_HIL_STEP)
REPORT_HERE(send_mission_item, message_mission_item, MESSAGE_MISSION_ITEM)
REPORT_HERE(send_description, message_description, MESSAGE_DESCRIPTION)
REPORT_HERE(send_own_gain, message_own_gain, MESSAGE_OWN_GAIN)

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
    send_fly_by_wire(line, &values);
}

void report_hil_surfaces(const report_line_t* line, const surfaces_t* surfaces)
{
    const message_hil_surfaces_t values = {
        .elevator = surfaces->elevator,
        .aileron = surfaces->aileron,
        .rudder = surfaces->rudder,
        .throttle = surfaces->throttle,
    };
    send_hil_surfaces(line, &values);
}

void report_hil_step(const report_line_t* line, uint32_t clock_ms, float step_s)
{
    const message_hil_step_t values = {.clock_ms = clock_ms, .step_s = step_s};
    send_hil_step(line, &values);
}

void report_description(const report_line_t* line, const description_summary_t* summary)
{
    const message_description_t values = {.table_size = (int32_t)summary->size, .table_crc32 = summary->crc32};
    send_description(line, &values);
}

void report_description_block(const report_line_t* line, size_t block, const uint8_t bytes[description_block_bytes])
{
    uint8_t payload[MESSAGE_DESCRIPTION_BLOCK_SIZE];
    protocol_put_i32(payload, (int32_t)block);
    memcpy(payload + 4, bytes, description_block_bytes);
    send(line, MESSAGE_DESCRIPTION_BLOCK_ID, payload, sizeof payload);
}

void report_own_topic(const report_line_t* line, uint32_t type_id, const uint8_t* payload, size_t size)
{
    send(line, type_id, payload, size);
}

void report_own_gain(const report_line_t* line, size_t row, float value)
{
    const message_own_gain_t values = {.row = (int32_t)row, .value = value};
    send_own_gain(line, &values);
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
    send_acknowledgement(line, &values);
}

void report_mission_count(const report_line_t* line, int32_t plan, size_t count)
{
    const message_mission_count_t values = {.plan = plan, .count = (int32_t)count};
    send_mission_count(line, &values);
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
    send_mission_item(line, &values);
}
