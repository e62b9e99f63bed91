#include "support/rig.h"

#include <stdlib.h>
#include <string.h>

static void receive(void* context, const uint8_t* frame, size_t size)
{
    rig_t* const rig = context;
    line_feed(&rig->out, frame, size, 0);
}

static rig_t* start(bool legacy, bool has_card)
{
    static rig_t rig;
    memset(&rig, 0, sizeof rig);
    card_init(&rig.card);
    line_init(&rig.out, &frame_from_board);
    const board_config_t config = {
        .legacy = legacy,
        .hil_period_s = 0.02F,
        .storage = has_card ? &rig.card.storage : NULL,
        .send = receive,
        .send_context = &rig,
    };
    board_init(&rig.board, &config);
    board_open(&rig.board, 0);
    return &rig;
}

rig_t* rig_start(void)
{
    return start(false, true);
}

rig_t* rig_start_legacy(void)
{
    return start(true, true);
}

rig_t* rig_start_without_card(void)
{
    return start(false, false);
}

board_action_t rig_send(rig_t* rig, uint32_t type_id, const uint8_t* payload, size_t size)
{
    line_clear(&rig->out);
    return board_handle_command(&rig->board, type_id, payload, size, rig->now_ms);
}

board_action_t rig_do(rig_t* rig, uint32_t type_id)
{
    return rig_send(rig, type_id, NULL, 0);
}

board_action_t rig_do_with(rig_t* rig, uint32_t type_id, int32_t value)
{
    uint8_t payload[4];
    protocol_put_i32(payload, value);
    return rig_send(rig, type_id, payload, sizeof payload);
}

board_action_t rig_do_with_two(rig_t* rig, uint32_t type_id, int32_t first, int32_t second)
{
    uint8_t payload[8];
    protocol_put_i32(payload, first);
    protocol_put_i32(payload + 4, second);
    return rig_send(rig, type_id, payload, sizeof payload);
}

static int acknowledged(const rig_t* rig, uint32_t type_id)
{
    const line_frame_t* const frame = line_newest(&rig->out, MESSAGE_ACKNOWLEDGEMENT_ID);
    if (frame == NULL)
    {
        return -1;
    }
    message_acknowledgement_t values;
    message_acknowledgement_unpack(&values, frame->payload);
    return values.command_type == (int32_t)type_id ? (int)values.result : -1;
}

int rig_ask(rig_t* rig, uint32_t type_id, const uint8_t* payload, size_t size)
{
    (void)rig_send(rig, type_id, payload, size);
    return acknowledged(rig, type_id);
}

int rig_ask_with(rig_t* rig, uint32_t type_id, int32_t value)
{
    (void)rig_do_with(rig, type_id, value);
    return acknowledged(rig, type_id);
}

int rig_ask_with_two(rig_t* rig, uint32_t type_id, int32_t first, int32_t second)
{
    (void)rig_do_with_two(rig, type_id, first, second);
    return acknowledged(rig, type_id);
}

int rig_ask_parameter(rig_t* rig, uint32_t type_id, float value)
{
    uint8_t payload[4];
    protocol_put_f32(payload, value);
    return rig_ask(rig, type_id, payload, sizeof payload);
}

void rig_extend(rig_t* rig)
{
    (void)rig_do(rig, COMMAND_CAPABILITIES_ID);
    line_clear(&rig->out);
}

command_xplane_info_t rig_level_flight(void)
{
    return (command_xplane_info_t){
        .throttle = 0.5F,
        .yaw_deg = 30.0F,
        .altitude_ft = 1000.0F,
        .speed_kt = 55.0F,
        .latitude_deg = 27.9319F,
        .longitude_deg = -15.3866F,
    };
}

message_hil_surfaces_t rig_fly(rig_t* rig, const command_xplane_info_t* info)
{
    uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
    command_xplane_info_pack(info, payload);
    rig->now_ms += 20;
    (void)rig_send(rig, COMMAND_XPLANE_INFO_ID, payload, sizeof payload);
    const line_frame_t* const frame = line_newest(&rig->out, MESSAGE_HIL_SURFACES_ID);
    if (frame == NULL || rig->out.count != 1)
    {
        abort(); // a command 50 has one answer; every test that flies relies on it
    }
    message_hil_surfaces_t values;
    message_hil_surfaces_unpack(&values, frame->payload);
    return values;
}

message_heartbeat_t rig_heartbeat(rig_t* rig)
{
    line_clear(&rig->out);
    board_send_streams(&rig->board, telemetry_task_param);
    const line_frame_t* const frame = line_newest(&rig->out, MESSAGE_HEARTBEAT_ID);
    message_heartbeat_t values = {0};
    if (frame != NULL)
    {
        message_heartbeat_unpack(&values, frame->payload);
    }
    return values;
}
