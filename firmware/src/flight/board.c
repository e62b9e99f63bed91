#include "flight/board.h"

#include <string.h>

#include "flight/board_command_context.h"
#include "flight/board_commands.h"
#include "flight/board_streams.h"
#include "flight/description.h"

static const uint32_t status_period_ms = 1000;
static const uint32_t first_extension = 0x100; ///< deployed boards know no command from here on

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
    board->is_legacy = config->legacy;
    board->table = description_summary();
    board->line = (report_line_t){.send = config->send, .is_idle = config->is_idle, .context = config->send_context};
    telemetry_init(&board->schedule);
    tuning_init(&board->tuning);
    board_plans_init(&board->plans);
    flight_loop_init(&board->flight);
    hil_loop_init(&board->hil, config->hil_period_s);
    servo_outputs_init(&board->servos);
    board_card_init(&board->card, config->storage);
    if (config->storage != NULL)
    {
        board_card_load_parameters(&board->card, config->card_is_silent, &board->tuning);
        if (!config->legacy)
        {
            board_card_load_own_gains(&board->card, config->card_is_silent, &board->tuning);
        }
        if (!config->legacy && !config->may_be_in_flight)
        {
            board_card_load_plans(&board->card, config->card_is_silent, &board->plans);
        }
    }
}

void board_open(board_t* board, uint32_t now_ms)
{
    board->station.is_extended = false;
    board->station.wants_steps = false;
    board->station.status_ms = now_ms;
    own_topics_switch(&board->own_topics, false, now_ms);
    board_plans_stop_reading(&board->plans);
    description_stop_reading(&board->reading);
}

command_result_t board_run_command(board_t* board, uint32_t type_id, const uint8_t* payload, size_t size,
                                   uint32_t now_ms)
{
    if (board->is_legacy && type_id >= first_extension)
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
    if (board->station.is_extended && type_id != COMMAND_DO_NOTHING_ID && type_id != COMMAND_XPLANE_INFO_ID)
    {
        report_acknowledgement(&board->line, type_id, result);
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

static void send_block(board_t* board)
{
    const report_line_t* const line = &board->line;
    const bool is_idle = line->is_idle == NULL || line->is_idle(line->context);
    size_t block = 0;
    uint8_t bytes[description_block_bytes];
    if (description_read_next(&board->reading, is_idle, &block) && description_block(block, bytes))
    {
        report_description_block(line, block, bytes);
    }
}

bool board_tick(board_t* board, uint32_t now_ms)
{
    if (board->station.is_extended && now_ms - board->station.status_ms >= status_period_ms)
    {
        board->station.status_ms = now_ms;
        board_send_status(board);
    }
    const int32_t plan = board->plans.reading;
    size_t index = 0;
    const waypoint_t* const waypoint = board_plans_read_next(&board->plans, &index);
    if (waypoint != NULL)
    {
        report_mission_item(&board->line, plan, index, waypoint);
    }
    board_send_own_topics(board, now_ms);
    send_block(board);
    return board_plans_is_reading(&board->plans) || description_is_reading(&board->reading);
}

void board_send_streams(board_t* board, telemetry_task_t task)
{
    for (size_t stream = 0; stream < telemetry_stream_count; stream++)
    {
        if (telemetry_is_due(&board->schedule, task, (telemetry_stream_t)stream))
        {
            board_send_stream(board, (telemetry_stream_t)stream);
        }
    }
}

void board_flight_step(board_t* board, float dt_s)
{
    measurements_note(&board->measured, dt_s);
    flight_loop_step(&board->flight, &board->measured, &board->tuning.gains, &board->plans.plan[board_plan_flight],
                     dt_s);
}

void board_supervise_hil(board_t* board, uint32_t now_ms)
{
    hil_loop_supervise(&board->hil, now_ms);
}

void board_servo_positions(const board_t* board, float positions[board_servo_count])
{
    servo_outputs_positions(&board->servos, &board->flight.loop.surfaces, &board->hil.loop.surfaces, positions);
}

void board_note_frames(board_t* board, uint32_t received, uint32_t rejected)
{
    board->station.frames_received = received;
    board->station.frames_rejected = rejected;
}
