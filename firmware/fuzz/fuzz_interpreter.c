// The interpreter and the whole board behind it: any bytes in any pieces at any time, with sensors that measure
// anything, in text mode, binary mode and AHRS test. All output is well formed, all kept
// values are in their ranges, no servo gets NaN, and the next good command is obeyed.
#include "fuzz.h"

#include <math.h>
#include <string.h>

#include "app/shell_reply.h"
#include "app/tty.h"
#include "flight/board_card.h"
#include "support/random.h"
#include "support/rig.h"

static rig_t* rig;
static shell_t shell;
static tty_t tty;
static char reply[shell_reply_bytes];

/// The interpreter of `rig`, in text mode.
static void start_interpreter(void)
{
    static const sensors_t no_models = {NULL, NULL, NULL, NULL};
    static const load_t load;
    static const task_health_t health[task_count];
    static const uint32_t frames_dropped = 0U;
    shell = (shell_t){.board = &rig->board,
                      .sensors = &no_models,
                      .load = &load,
                      .health = health,
                      .frames_dropped = &frames_dropped};
    tty_init(&tty, &shell, reply, sizeof reply);
}

static void start(uint32_t flags)
{
    const bool legacy = (flags & 0x100U) != 0U;
    const bool has_card = (flags & 0x200U) != 0U;
    rig = legacy ? rig_start_legacy() : has_card ? rig_start() : rig_start_without_card();
    start_interpreter();
}

/// Restart the board with its card.
static void restart(uint32_t flags)
{
    const uint32_t now_ms = rig->now_ms;
    if (rig->board.is_legacy)
    {
        start(flags);
    }
    else
    {
        rig = rig_start_on(rig->board.card.storage);
        start_interpreter();
    }
    rig->now_ms = now_ms;
}

static bool is_text(char character)
{
    return (character >= ' ' && character <= '~') || character == '\r' || character == '\n' || character == '\t';
}

/// Take the reply, as the application does.
static void take_reply(void)
{
    fuzz_require(tty.reply.size <= sizeof reply, "a reply stays inside of its buffer");
    for (size_t i = 0; i < tty.reply.size; i++)
    {
        fuzz_require(is_text(reply[i]), "a reply is text");
    }
    tty.reply.size = 0U;
}

/// Do what the application does for the card, which works here.
static void store(board_keeps_t what)
{
    if (rig->board.card.storage != NULL)
    {
        const size_t taken = board_card_take(&rig->board.card, what, &rig->board.tuning, &rig->board.plans);
        const record_state_t state = board_card_write(&rig->board.card, what, taken);
        fuzz_require(state == record_whole, "a good card stores what it is given");
        (void)board_card_note(&rig->board.card, what, state);
    }
}

/// Fulfil a request, as the application does.
static void fulfil(shell_request_t request, uint32_t flags)
{
    if (request == shell_asks_reset)
    {
        restart(flags);
    }
    else if (request == shell_asks_store || request == shell_asks_store_acknowledged)
    {
        store(board_keeps_parameters);
        shell_tell_stored(&tty.reply, true);
    }
    else if (request == shell_asks_load)
    {
        shell_tell_loaded(&tty.reply, false);
    }
    else if (request == shell_asks_store_plans)
    {
        for (board_keeps_t next = board_card_next(&rig->board.plans); next != board_keeps_count;
             next = board_card_next(&rig->board.plans))
        {
            store(next);
        }
    }
    take_reply();
}

static void hear(const uint8_t* bytes, size_t size, uint32_t flags)
{
    size_t taken = 0U;
    shell_request_t request = shell_asks_nothing;
    do
    {
        const tty_mode_t mode = tty.mode;
        const size_t more = tty_receive(&tty, bytes + taken, size - taken, rig->now_ms);
        fuzz_require(more <= size - taken, "no more bytes are taken than there are");
        taken += more;
        request = shell.request;
        shell.request = shell_asks_nothing;
        take_reply();
        fuzz_require(taken == size || more > 0U || request != shell_asks_nothing || tty.mode != mode,
                     "bytes are taken, or something is asked for");
        fulfil(request, flags);
    } while (taken < size || request != shell_asks_nothing);
}

/// Mostly a value that a sensor measures, sometimes one that no sensor should.
static float reading(uint32_t* random)
{
    static const float odd[] = {NAN, NAN, NAN, INFINITY, -INFINITY, 3.4e38F, -3.4e38F, 1e-40F};
    const uint32_t number = random_next(random);
    if ((number & 0xFU) == 0U)
    {
        return odd[(number >> 4U) % (sizeof odd / sizeof odd[0])];
    }
    return (float)(int32_t)number / 1.0e7F; // up to +-214
}

/// Fill all messages of the sensors, which consist of 32-bit words, most of them floats.
static void measure(uint32_t* random)
{
    uint8_t payload[MESSAGE_SERVOS_IN_SIZE];
    _Static_assert(sizeof payload >= MESSAGE_ANALOG_SIZE, "the longest reading");
    for (size_t i = 0; i < sizeof payload; i += 4U)
    {
        protocol_put_f32(payload + i, reading(random));
    }
    board_sensors_t* const sensors = &rig->board.measured.sensors;
    message_ahrs_unpack(&sensors->ahrs, payload);
    message_inertial_unpack(&sensors->inertial, payload);
    message_analog_unpack(&sensors->analog, payload);
    message_servos_in_unpack(&sensors->servos_in, payload);
    message_gps_unpack(&sensors->gps, payload);
    sensors->gps.valid = (random_next(random) & 1U) != 0U ? 'A' : 'V';
}

static void require_servos(void)
{
    float positions[board_servo_count];
    board_servo_positions(&rig->board, positions);
    for (size_t i = 0; i < board_servo_count; i++)
    {
        // written so that a NaN fails
        fuzz_require(positions[i] >= -1.0F && positions[i] <= 1.0F, "every servo gets a position in its range");
    }
}

static void require_state(void)
{
    const board_t* const board = &rig->board;
    fuzz_require(parameters_are_valid(&board->tuning.parameters), "no parameter leaves its range");
    fuzz_require(board->plans.reading < board_plan_count, "a plan that exists is read back");
    for (size_t i = 0; i < board_plan_count; i++)
    {
        const plan_t* const plan = &board->plans.plan[i];
        fuzz_require(plan->count <= plan_waypoints_max && plan->current <= plan->count,
                     "a plan stays inside of itself");
        for (size_t k = 0; k < plan->count; k++)
        {
            fuzz_require(waypoint_is_valid(&plan->waypoints[k]), "every waypoint can be flown");
        }
    }
    for (size_t i = 0; i < telemetry_task_count; i++)
    {
        const uint32_t period_ms = board->schedule.period_ms[i];
        fuzz_require(period_ms >= 20U && period_ms <= 10000U, "every period is in its range");
    }
    fuzz_require(tty.decoder.received == board->station.frames_received || tty.mode != tty_binary,
                 "frames are counted once");
}

static void require_output(void)
{
    const frame_decoder_t* const decoder = &rig->out.decoder;
    fuzz_require(decoder->noise_bytes == 0U && frame_decoder_rejected(decoder) == 0U, "every frame sent is good");
    fuzz_require(!frame_decoder_is_waiting(decoder), "every frame sent is complete");
    for (size_t i = 0; i < rig->out.count && i < line_frames_max; i++)
    {
        fuzz_require(!rig->board.is_legacy || rig->out.frames[i].type_id < 0x100U, "legacy boards extend nothing");
    }
    line_clear(&rig->out);
}

/// Do what the other tasks do meanwhile.
static void live(fuzz_input_t* input)
{
    // a pause this long ends a frame, so it is rare
    static const uint32_t flow_ms[] = {0, 1, 10, 20};
    static const uint32_t pauses_ms[] = {100, tty_silence_ms, 600, 1000};
    const bool flows = random_below(&input->random, 32U) != 0U;
    rig->now_ms += (flows ? flow_ms : pauses_ms)[random_below(&input->random, 4U)];
    tty_tick(&tty, rig->now_ms);
    tty.reply.size = 0U; // records of the AHRS test are binary
    if (random_below(&input->random, 4U) == 0U)
    {
        measure(&input->random);
    }
    board_supervise_hil(&rig->board, rig->now_ms);
    board_flight_step(&rig->board, 0.02F);
    const telemetry_task_t task = (telemetry_task_t)random_below(&input->random, telemetry_task_count);
    board_send_streams(&rig->board, task);
    require_servos();
    require_state();
    require_output();
}

/// A station that comes after a pause is understood, whatever was on the line before.
static void require_next_command(uint32_t flags)
{
    static const char opening[] = "\n#QT\n";
    uint8_t frame[frame_max_bytes];
    const size_t size = frame_encode(&frame_to_board, COMMAND_READ_ALL_ID, NULL, 0U, frame, sizeof frame);
    rig->now_ms += tty_silence_ms;
    tty_tick(&tty, rig->now_ms);
    tty.reply.size = 0U;
    hear((const uint8_t*)opening, sizeof opening - 1U, flags);
    fuzz_require(tty.mode == tty_binary, "a station can always open the line");
    line_clear(&rig->out);
    hear(frame, size, flags);
    fuzz_require(line_newest(&rig->out, MESSAGE_HEARTBEAT_ID) != NULL, "its first command is obeyed");
    require_output();
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    fuzz_input_t input;
    if (!fuzz_read_input(&input, bytes, size))
    {
        return 0;
    }
    start(input.flags);
    while (input.line_size > 0U)
    {
        const size_t piece = fuzz_piece(&input, input.line_size);
        hear(input.line, piece, input.flags);
        input.line += piece;
        input.line_size -= piece;
        live(&input);
    }
    require_next_command(input.flags);
    return 0;
}
