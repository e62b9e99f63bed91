#include "flight/board_streams.h"

static int8_t flag(bool on)
{
    return on ? 1 : 0;
}

static void send_heartbeat(board_t* board)
{
    hil_loop_refresh_switches(&board->hil, &board->measured);
    const bool* const on = board->schedule.on;
    const bool autopilot = measurements_autopilot(&board->measured);
    const int hil = (board->hil.autopilot ? MESSAGE_HEARTBEAT_BIT_AUTOPILOT_HIL : 0) |
                    (board->hil.source == control_source_joystick ? MESSAGE_HEARTBEAT_BIT_SOURCE_JOYSTICK : 0);
    const message_heartbeat_t values = {
        .autopilot = flag(autopilot),
        .autotrim = flag(measurements_autotrim(&board->measured)),
        .auto_switch = flag(autopilot),
        .servos = flag(on[telemetry_servos_in]),
        .gps = flag(on[telemetry_gps]),
        .statistics = flag(on[telemetry_statistics]),
        .ahrs = flag(on[telemetry_ahrs]),
        .inertial = flag(on[telemetry_inertial]),
        .analog = flag(on[telemetry_analog]),
        .fly_by_wire = flag(on[telemetry_fly_by_wire]),
        .autopilot_hil = (int8_t)hil,
        .autotrim_hil = flag(board->hil.autotrim),
    };
    report_heartbeat(&board->line, &values);
}

static void send_flight_plan(const board_t* board)
{
    const control_loop_input_t input = flight_loop_input(&board->flight, &board->measured);
    report_plan(&board->line, MESSAGE_FMS_PLAN_ID, &board->plans.plan[board_plan_flight], &input.position,
                input.speed_kt);
}

static void send_hil_plan(const board_t* board)
{
    const control_loop_input_t input = hil_loop_input(&board->hil, &board->measured);
    report_plan(&board->line, MESSAGE_FMS_HIL_PLAN_ID, &board->plans.plan[board_plan_hil], &input.position,
                input.speed_kt);
}

void board_send_stream(board_t* board, telemetry_stream_t stream)
{
    const report_line_t* const line = &board->line;
    const board_sensors_t* const sensors = &board->measured.sensors;
    switch (stream)
    {
    case telemetry_heartbeat:
        send_heartbeat(board);
        break;
    case telemetry_ahrs:
        report_ahrs(line, &sensors->ahrs);
        break;
    case telemetry_inertial:
        report_inertial(line, &sensors->inertial);
        break;
    case telemetry_analog:
        report_analog(line, &sensors->analog);
        break;
    case telemetry_fms_plan:
        send_flight_plan(board);
        break;
    case telemetry_fms_hil_plan:
        send_hil_plan(board);
        break;
    case telemetry_statistics:
        report_statistics(line, &sensors->statistics);
        break;
    case telemetry_gps:
        report_gps(line, &sensors->gps);
        break;
    case telemetry_servos_in:
        report_servos_in(line, &sensors->servos_in);
        break;
    case telemetry_fly_by_wire:
        report_fly_by_wire(line, &board->flight.loop.surfaces);
        break;
    case telemetry_stream_count:
        break;
    }
}

/// The simulated aircraft while its simulator is heard, else the real one.
static own_topics_source_t source_of_own_topics(const board_t* board)
{
    const hil_loop_t* const hil = &board->hil;
    const bool is_simulated = hil->has_newest && !failsafe_is_active(&hil->missing, failsafe_simulator_silent);
    const control_loop_input_t input =
        is_simulated ? hil_loop_input(hil, &board->measured) : flight_loop_input(&board->flight, &board->measured);
    const plan_t* const plan = &board->plans.plan[is_simulated ? board_plan_hil : board_plan_flight];
    return (own_topics_source_t){
        .loop = is_simulated ? &hil->loop : &board->flight.loop,
        .has_line = plan->count > 0 && position_is_valid(&input.position),
    };
}

void board_send_own_topics(board_t* board, uint32_t now_ms)
{
    for (size_t i = 0; i < own_topic_count; i++)
    {
        const own_topic_id_t topic = (own_topic_id_t)i;
        if (own_topics_is_due(&board->own_topics, topic, now_ms))
        {
            const own_topics_source_t source = source_of_own_topics(board);
            uint8_t payload[own_topic_payload_max_bytes];
            const size_t size = own_topics_payload(topic, &source, payload);
            report_own_topic(&board->line, own_topics_definition(topic)->type_word, payload, size);
        }
    }
}

void board_send_capabilities(const board_t* board, uint32_t now_ms)
{
    const uint32_t uptime_ms = now_ms & 0x7FFFFFFFU;
    message_capabilities_t values = {
        .protocol_version = 1,
        .features = MESSAGE_CAPABILITIES_BIT_HAS_ACKNOWLEDGEMENTS | MESSAGE_CAPABILITIES_BIT_HAS_SOURCES |
                    MESSAGE_CAPABILITIES_BIT_HAS_MISSIONS | MESSAGE_CAPABILITIES_BIT_HAS_HIL_STEPS |
                    MESSAGE_CAPABILITIES_BIT_DESCRIBES_ITSELF,
        .firmware_name = BOARD_FIRMWARE_NAME,
        .firmware_version = BOARD_FIRMWARE_VERSION,
        .uptime_ms = (int32_t)uptime_ms,
    };
    if (board->card.storage != NULL)
    {
        values.features |= MESSAGE_CAPABILITIES_BIT_HAS_STORE;
    }
    if (board_card_alarms(&board->card))
    {
        values.features |= MESSAGE_CAPABILITIES_BIT_HAS_CARD_ALARM;
    }
    report_capabilities(&board->line, &values);
}

void board_send_status(const board_t* board)
{
    const message_board_status_t values = {
        .airspeed_source = board->flight.airspeed_source,
        .altitude_source = board->flight.altitude_source,
        .servos_control_mode = (int32_t)board->servos.mode,
        .hil_plan_name = board->plans.hil_route,
        .frames_received = board->station.frames_received,
        .frames_rejected = board->station.frames_rejected,
    };
    report_status(&board->line, &values);
}
