#include "app/tty.h"

#include <math.h>
#include <string.h>

#include "common/bytes.h"

static const char open_binary[] = "#QT";
static const char frame_begin[] = "#QT,";
static const char announce_ahrs[] = "#sim";
static const char start_ahrs[] = "#s00";
static const char ahrs_started[] = "#SYNCH00\n\r";
static const uint8_t ahrs_mark[4] = {0xAA, 0xAA, 0xAA, 0xAA};
static const char stop_ahrs = 'q';

void tty_init(tty_t* tty, shell_t* shell, char* reply, size_t reply_bytes)
{
    memset(tty, 0, sizeof *tty);
    tty->mode = tty_text;
    tty->shell = shell;
    text_init(&tty->reply, reply, reply_bytes);
    frame_decoder_init(&tty->decoder, &board_frames_in);
}

static void enter_binary(tty_t* tty, uint32_t now_ms)
{
    tty->mode = tty_binary;
    board_open(tty->shell->board, now_ms);
}

/// Run one complete line. Lines that nobody typed (parts of frames, noise) get no answer.
static void run_line(tty_t* tty, uint32_t now_ms)
{
    tty->line[tty->line_size] = '\0';
    const bool announced = tty->ahrs_announced;
    tty->ahrs_announced = false;
    if (tty->line_size == 0 || tty->line_is_noise || strncmp(tty->line, frame_begin, sizeof frame_begin - 1) == 0)
    {
        tty->ahrs_announced = announced;
    }
    else if (tty->line_is_long)
    {
        text_add(&tty->reply, "\rtoo long: a line has 95 characters at most\n");
    }
    else if (strcmp(tty->line, open_binary) == 0)
    {
        enter_binary(tty, now_ms);
    }
    else if (strcmp(tty->line, announce_ahrs) == 0)
    {
        tty->ahrs_announced = true;
    }
    else if (strcmp(tty->line, start_ahrs) == 0 && announced)
    {
        text_add(&tty->reply, ahrs_started);
        tty->mode = tty_ahrs_test;
        tty->record_ms = now_ms;
    }
    else
    {
        tty->shell->now_ms = now_ms;
        shell_run(tty->shell, tty->line, &tty->reply);
    }
}

static bool ends_line(const tty_t* tty, uint8_t byte)
{
    // The second order of the AHRS test ends in a zero byte; anywhere else a zero byte is noise.
    const bool is_start = tty->line_size == sizeof start_ahrs - 1 && memcmp(tty->line, start_ahrs, tty->line_size) == 0;
    return byte == '\n' || byte == '\r' || (byte == '\0' && is_start);
}

/// One byte of text; true when it ended a line.
static bool take_character(tty_t* tty, uint8_t byte, uint32_t now_ms)
{
    if (ends_line(tty, byte))
    {
        run_line(tty, now_ms);
        tty->line_size = 0;
        tty->line_is_noise = false;
        tty->line_is_long = false;
        return true;
    }
    if (byte == '\b' || byte == 0x7FU)
    {
        tty->line_size -= tty->line_size > 0 ? 1U : 0U;
    }
    else if ((byte < ' ' && byte != '\t') || byte > '~')
    {
        tty->line_is_noise = true;
    }
    else if (tty->line_size + 1 < sizeof tty->line)
    {
        tty->line[tty->line_size] = (char)byte;
        tty->line_size++;
    }
    else
    {
        tty->line_is_long = true;
    }
    return false;
}

static size_t receive_text(tty_t* tty, const uint8_t* bytes, size_t size, uint32_t now_ms)
{
    size_t taken = 0;
    bool is_over = false;
    while (taken < size && !is_over)
    {
        is_over = take_character(tty, bytes[taken], now_ms);
        taken++;
    }
    return taken;
}

/// In the AHRS test: `q` at any place ends the test, and so does a station that opens the line.
static size_t receive_ahrs_test(tty_t* tty, const uint8_t* bytes, size_t size, uint32_t now_ms)
{
    size_t taken = 0;
    while (taken < size && tty->mode == tty_ahrs_test)
    {
        const uint8_t byte = bytes[taken];
        taken++;
        const bool opens = byte == '\n' && tty->line_size == sizeof open_binary - 1 &&
                           memcmp(tty->line, open_binary, tty->line_size) == 0;
        if (byte == (uint8_t)stop_ahrs)
        {
            tty->mode = tty_text;
        }
        else if (opens)
        {
            enter_binary(tty, now_ms);
        }
        const bool goes_on = tty->mode == tty_ahrs_test && tty->line_size < sizeof open_binary - 1 &&
                             byte == (uint8_t)open_binary[tty->line_size];
        tty->line[tty->line_size] = (char)byte;
        tty->line_size = goes_on ? tty->line_size + 1U : 0U;
    }
    return taken;
}

/// Return to text mode; returns how many bytes the decoder held.
static size_t leave_binary(tty_t* tty)
{
    const size_t held = tty->decoder.end - tty->decoder.start;
    tty->decoder.start = tty->decoder.end;
    tty->mode = tty_text;
    return held;
}

/// Run one command. The board must not wait for the card, so a command that needs it becomes a request.
static void run_command(tty_t* tty, const frame_t* frame, uint32_t now_ms)
{
    board_t* const board = tty->shell->board;
    const bool has_card = !board->is_legacy && board->card.storage != NULL;
    if (has_card && frame->type_id == COMMAND_STORE_PARAMETERS_ID && frame->payload_size == 0)
    {
        tty->shell->request = shell_asks_store_acknowledged;
        return;
    }
    const board_action_t action =
        board_handle_command(board, frame->type_id, frame->payload, frame->payload_size, now_ms);
    if (frame->type_id == COMMAND_MISSION_COMMIT_ID && board_card_next(&board->plans) != board_keeps_count)
    {
        tty->shell->request = shell_asks_store_plans;
    }
    switch (action)
    {
    case board_goes_on:
        break;
    case board_leaves_binary_mode:
        tty->mode = tty_text;
        break;
    case board_resets:
        tty->mode = tty_text;
        tty->shell->request = shell_asks_reset;
        break;
    }
}

/// Handle the next event of the decoder; true when it may hold another one that can be handled now.
static bool run_frame(tty_t* tty, uint32_t now_ms)
{
    frame_t frame;
    const frame_event_t event = frame_decoder_next(&tty->decoder, &frame);
    board_note_frames(tty->shell->board, tty->decoder.received, frame_decoder_rejected(&tty->decoder));
    switch (event)
    {
    case frame_event_frame:
        run_command(tty, &frame, now_ms);
        break;
    case frame_event_greeting:
        board_open(tty->shell->board, now_ms);
        break;
    case frame_event_none:
        break;
    }
    return event != frame_event_none && tty->mode == tty_binary && tty->shell->request == shell_asks_nothing;
}

static size_t receive_binary(tty_t* tty, const uint8_t* bytes, size_t size, uint32_t now_ms)
{
    size_t taken = 0;
    do
    {
        // First the events that a request left in the decoder.
        while (run_frame(tty, now_ms))
        {
        }
        if (tty->mode != tty_binary || tty->shell->request != shell_asks_nothing || taken == size)
        {
            break;
        }
        taken += frame_decoder_feed(&tty->decoder, bytes + taken, size - taken);
    } while (true);
    if (tty->mode == tty_binary)
    {
        return taken;
    }
    // The bytes after the last command are text already.
    const size_t behind = leave_binary(tty);
    return behind < taken ? taken - behind : taken;
}

size_t tty_receive(tty_t* tty, const uint8_t* bytes, size_t size, uint32_t now_ms)
{
    tty->heard_ms = size > 0 ? now_ms : tty->heard_ms;
    switch (tty->mode)
    {
    case tty_binary:
        return receive_binary(tty, bytes, size, now_ms);
    case tty_ahrs_test:
        return receive_ahrs_test(tty, bytes, size, now_ms);
    case tty_text:
        break;
    }
    return receive_text(tty, bytes, size, now_ms);
}

/// Send no record while the attitude is unknown.
static void add_record(tty_t* tty)
{
    const message_ahrs_t* const ahrs = &tty->shell->board->measured.sensors.ahrs;
    if (!isfinite(ahrs->yaw_deg) || !isfinite(ahrs->pitch_deg) || !isfinite(ahrs->roll_deg))
    {
        return;
    }
    uint8_t record[16];
    memcpy(record, ahrs_mark, sizeof ahrs_mark);
    bytes_write_f32(record + 4, ahrs->yaw_deg);
    bytes_write_f32(record + 8, ahrs->pitch_deg);
    bytes_write_f32(record + 12, ahrs->roll_deg);
    if (tty->reply.capacity - tty->reply.size >= sizeof record)
    {
        memcpy(tty->reply.bytes + tty->reply.size, record, sizeof record);
        tty->reply.size += sizeof record;
    }
}

void tty_tick(tty_t* tty, uint32_t now_ms)
{
    if (tty->mode == tty_binary)
    {
        if (frame_decoder_is_waiting(&tty->decoder) && now_ms - tty->heard_ms >= tty_silence_ms)
        {
            // A false header may have hidden good commands.
            frame_decoder_expire(&tty->decoder);
            (void)receive_binary(tty, tty->decoder.buffer, 0, now_ms);
        }
        if (tty->mode == tty_binary)
        {
            (void)board_tick(tty->shell->board, now_ms);
        }
    }
    else if (tty->mode == tty_ahrs_test && now_ms - tty->record_ms >= tty_ahrs_period_ms)
    {
        tty->record_ms = now_ms;
        add_record(tty);
    }
}

uint32_t tty_wait_ms(const tty_t* tty)
{
    switch (tty->mode)
    {
    case tty_binary:
        return tty_binary_period_ms;
    case tty_ahrs_test:
        return tty_ahrs_period_ms;
    case tty_text:
        break;
    }
    return UINT32_MAX;
}
