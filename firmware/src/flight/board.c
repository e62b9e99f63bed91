#include "flight/board.h"

#include <string.h>

#include "flight/board_card.h"
#include "flight/board_commands.h"
#include "flight/board_reports.h"

static const uint32_t status_period_ms = 1000;
static const uint32_t first_extension = 0x100; ///< deployed boards know nothing from here on

/// Servo outputs that a law drives, in the order of the receiver's channels.
enum
{
    driven_servos = 4
};

static int32_t incoming_size(uint32_t type_id)
{
    const int32_t size = protocol_command_size(type_id);
    return size < 0 ? 0 : size;
}

const frame_dialect_t board_frames_in = {
    .header = PROTOCOL_TO_BOARD_HEADER,
    .type_flags = 0U,
    .payload_size = incoming_size,
    .has_greeting = true,
};

void board_init(board_t* board, const board_config_t* config)
{
    memset(board, 0, sizeof *board);
    board->config = *config;
    telemetry_init(&board->schedule);
    parameters_init(&board->parameters);
    board->source = board_source_rc;
    board->airspeed_source = COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_PITOT;
    board->altitude_source = COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_BAROMETER;
    board->servos_mode = board_servos_fly_by_wire;
    board->hil_plan_name = MESSAGE_BOARD_STATUS_HIL_PLAN_NAME_NONE;
    board->reading_plan = -1;
    mission_init(&board->mission);
    for (size_t i = 0; i < board_plan_count; i++)
    {
        plan_clear(&board->plans[i]);
        control_loop_init(&board->loops[i]);
    }
    board_card_load(board);
}

void board_open(board_t* board, uint32_t now_ms)
{
    board->extended = false;
    board->reading_plan = -1;
    board->status_ms = now_ms;
}

command_result_t board_run_command(board_t* board, uint32_t type_id, const uint8_t* payload, size_t size,
                                   uint32_t now_ms)
{
    if (board->config.legacy && type_id >= first_extension)
    {
        return command_unknown;
    }
    board_command_context_t context = {.board = board, .now_ms = now_ms};
    return command_dispatch(board_commands, board_commands_count, &context, type_id, payload, size);
}

board_action_t board_handle_command(board_t* board, uint32_t type_id, const uint8_t* payload, size_t size,
                                    uint32_t now_ms)
{
    const command_result_t result = board_run_command(board, type_id, payload, size, now_ms);
    if (board->extended && type_id != COMMAND_DO_NOTHING_ID && type_id != COMMAND_XPLANE_INFO_ID)
    {
        board_report_acknowledgement(board, type_id, result);
    }
    if (result == command_done && type_id == COMMAND_EXIT_BINARY_MODE_ID)
    {
        return board_leaves_binary_mode;
    }
    if (result == command_done && type_id == COMMAND_RESET_ID)
    {
        return board_resets;
    }
    return board_goes_on;
}

bool board_tick(board_t* board, uint32_t now_ms)
{
    if (board->extended && now_ms - board->status_ms >= status_period_ms)
    {
        board->status_ms = now_ms;
        board_report_status(board);
    }
    if (board->reading_plan < 0)
    {
        return false;
    }
    if (board->reading_index < board->plans[board->reading_plan].count)
    {
        board_report_mission_item(board, board->reading_plan, board->reading_index);
        board->reading_index++;
    }
    if (board->reading_index >= board->plans[board->reading_plan].count)
    {
        board->reading_plan = -1;
    }
    return board->reading_plan >= 0;
}

void board_send_streams(board_t* board, telemetry_task_t task)
{
    for (size_t stream = 0; stream < telemetry_stream_count; stream++)
    {
        if (telemetry_is_due(&board->schedule, task, (telemetry_stream_t)stream))
        {
            board_report_stream(board, (telemetry_stream_t)stream);
        }
    }
}

void board_servo_positions(const board_t* board, float positions[board_servo_count])
{
    const size_t loop = board->servos_mode == board_servos_hil ? board_plan_hil : board_plan_flight;
    const surfaces_t* const surfaces = &board->loops[loop].surfaces;
    const float driven[driven_servos] = {
        [rc_channel_aileron] = surfaces->aileron,
        [rc_channel_elevator] = surfaces->elevator,
        [rc_channel_throttle] = surfaces->throttle,
        [rc_channel_rudder] = surfaces->rudder,
    };
    for (size_t i = 0; i < board_servo_count; i++)
    {
        const bool follows_law = i < driven_servos && !board->servo_is_commanded[i];
        positions[i] = follows_law ? driven[i] : board->servo_out[i];
    }
}

void board_note_frames(board_t* board, uint32_t received, uint32_t rejected)
{
    board->frames_received = received;
    board->frames_rejected = rejected;
}
