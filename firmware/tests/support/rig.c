#include "support/rig.h"

#include <stdlib.h>
#include <string.h>

static void receive(void* context, const uint8_t* frame, size_t size)
{
    rig_t* const rig = context;
    line_feed(&rig->out, frame, size, 0);
}

static rig_t rig_in_use;

static rig_t* start(bool legacy, const storage_t* storage)
{
    rig_t* const rig = &rig_in_use;
    rig->now_ms = 0;
    line_init(&rig->out, &frame_from_board);
    rig->config = (board_config_t){
        .legacy = legacy,
        .hil_period_s = 0.02F,
        .storage = storage,
        .send = receive,
        .send_context = rig,
    };
    board_init(&rig->board, &rig->config);
    board_open(&rig->board, 0);
    return rig;
}

/// An empty card.
static const storage_t* new_card(void)
{
    card_init(&rig_in_use.card);
    return &rig_in_use.card.storage;
}

rig_t* rig_start(void)
{
    return start(false, new_card());
}

rig_t* rig_start_legacy(void)
{
    return start(true, new_card());
}

rig_t* rig_start_without_card(void)
{
    return start(false, NULL);
}

rig_t* rig_start_on(const storage_t* storage)
{
    return start(false, storage);
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

waypoint_t rig_waypoint(uint32_t seed, int32_t index)
{
    const double place = (double)seed + (double)index / 1000.0;
    return (waypoint_t){
        .position = {.latitude_deg = place, .longitude_deg = -place},
        .altitude_ft = 100.0F * (float)seed + (float)index,
        .speed_kt = 50.0F + (float)seed,
    };
}

int rig_upload(rig_t* rig, int32_t plan, int32_t count, uint32_t seed)
{
    (void)rig_do_with_two(rig, COMMAND_MISSION_BEGIN_ID, plan, count);
    for (int32_t i = 0; i < count; i++)
    {
        const waypoint_t waypoint = rig_waypoint(seed, i);
        const command_mission_item_t item = {
            .plan = plan,
            .index = i,
            .latitude_deg = waypoint.position.latitude_deg,
            .longitude_deg = waypoint.position.longitude_deg,
            .altitude_ft = waypoint.altitude_ft,
            .speed_kt = waypoint.speed_kt,
        };
        uint8_t payload[COMMAND_MISSION_ITEM_SIZE];
        command_mission_item_pack(&item, payload);
        (void)rig_send(rig, COMMAND_MISSION_ITEM_ID, payload, sizeof payload);
    }
    return rig_ask_with(rig, COMMAND_MISSION_COMMIT_ID, plan);
}

bool rig_keep_plans(rig_t* rig)
{
    bool done = true;
    for (board_keeps_t next = board_card_next(&rig->board.plans); next != board_keeps_count;
         next = board_card_next(&rig->board.plans))
    {
        const size_t taken = board_card_take(&rig->board.card, next, &rig->board.tuning, &rig->board.plans);
        const record_state_t state = board_card_write(&rig->board.card, next, taken);
        (void)board_card_note(&rig->board.card, next, state);
        done = done && state == record_whole;
    }
    return done;
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
