#include "support/cmocka_all.h"

#include <string.h>

#include "app/tty.h"
#include "flight/board_card.h"
#include "support/rig.h"

static rig_t* rig;
static shell_t shell;
static load_t load;
static const task_health_t health[task_count];
static uint32_t frames_dropped;
static tty_t tty;
static char reply[shell_reply_bytes];

static int start(void** state)
{
    (void)state;
    rig = rig_start();
    static const sensors_t sensors = {NULL, NULL, NULL, NULL};
    shell = (shell_t){
        .board = &rig->board, .sensors = &sensors, .load = &load, .health = health, .frames_dropped = &frames_dropped};
    tty_init(&tty, &shell, reply, sizeof reply - 1);
    line_clear(&rig->out);
    return 0;
}

/// Everything, as the application gives it, without taking out the reply. The last request stays in the shell.
static void hear(const char* bytes, size_t size)
{
    for (size_t taken = 0; taken < size;)
    {
        taken += tty_receive(&tty, (const uint8_t*)bytes + taken, size - taken, rig->now_ms);
    }
}

static void hear_line(const char* line)
{
    hear(line, strlen(line));
}

static const char* answer(void)
{
    reply[tty.reply.size] = '\0';
    tty.reply.size = 0;
    return reply;
}

/// A command's frame at `out`; its length.
static size_t frame_of(uint32_t type_id, uint8_t* out)
{
    return frame_encode(&frame_to_board, type_id, NULL, 0, out, frame_max_bytes);
}

static void a_line_is_answered_when_it_ends(void** state)
{
    (void)state;
    hear_line("versi");
    assert_string_equal(answer(), "");
    hear_line("on\n");
    assert_string_equal(answer(), "\r" BOARD_FIRMWARE_NAME " " BOARD_FIRMWARE_VERSION "\n");
}

static void bytes_are_taken_up_to_the_end_of_a_line(void** state)
{
    (void)state;
    static const char two[] = "version\nversion\n";
    assert_int_equal(tty_receive(&tty, (const uint8_t*)two, sizeof two - 1, 0), 8);
}

static void the_greeting_opens_binary_mode_in_any_pieces(void** state)
{
    (void)state;
    static const char greeting[] = "#QT\n";
    for (size_t cut = 0; cut < sizeof greeting; cut++)
    {
        start(state);
        hear(greeting, cut);
        assert_int_equal(tty.mode, cut == 4 ? tty_binary : tty_text);
        hear(greeting + cut, 4 - cut);
        assert_int_equal(tty.mode, tty_binary);
    }
}

static void the_exit_command_gives_text_mode_back_and_what_follows_it_is_text(void** state)
{
    (void)state;
    hear_line("#QT\n");
    uint8_t bytes[frame_max_bytes + 16];
    const size_t size = frame_of(COMMAND_EXIT_BINARY_MODE_ID, bytes);
    memcpy(bytes + size, "version\n", 8);
    hear((const char*)bytes, size + 8);
    assert_int_equal(tty.mode, tty_text);
    assert_string_equal(answer(), "\r" BOARD_FIRMWARE_NAME " " BOARD_FIRMWARE_VERSION "\n");
}

static void a_request_stops_the_reading_and_nothing_behind_it_is_lost(void** state)
{
    (void)state;
    hear_line("#QT\n");
    uint8_t bytes[4 * frame_max_bytes];
    size_t size = frame_of(COMMAND_STORE_PARAMETERS_ID, bytes);
    size += frame_of(COMMAND_STORE_PARAMETERS_ID, bytes + size);
    size += frame_of(COMMAND_GPS_ON_ID, bytes + size);
    size_t taken = 0;
    size_t stores = 0;
    for (int i = 0; i < 5; i++)
    {
        taken += tty_receive(&tty, bytes + taken, size - taken, 0);
        stores += shell.request == shell_asks_store_acknowledged ? 1U : 0U;
        shell.request = shell_asks_nothing;
    }
    assert_int_equal(stores, 2);
    assert_int_equal(taken, size);
    assert_true(rig->board.schedule.on[telemetry_gps]);
}

static void without_a_card_the_board_itself_refuses_to_store(void** state)
{
    (void)state;
    rig = rig_start_without_card();
    rig_extend(rig);
    hear_line("#QT\n");
    rig_extend(rig);
    uint8_t bytes[frame_max_bytes];
    hear((const char*)bytes, frame_of(COMMAND_STORE_PARAMETERS_ID, bytes));
    assert_int_equal(shell.request, shell_asks_nothing);
    const line_frame_t* const said = line_newest(&rig->out, MESSAGE_ACKNOWLEDGEMENT_ID);
    assert_non_null(said);
    assert_int_equal(protocol_get_i32(said->payload + 4), command_storage_failed);
}

static void a_committed_plan_is_to_be_stored_before_the_next_command_is_done(void** state)
{
    (void)state;
    hear_line("#QT\n");
    rig_extend(rig);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_MISSION_BEGIN_ID, board_plan_hil, 1), command_done);
    const command_mission_item_t item = {.plan = board_plan_hil, .latitude_deg = 28.0, .longitude_deg = -15.0};
    uint8_t payload[COMMAND_MISSION_ITEM_SIZE];
    command_mission_item_pack(&item, payload);
    (void)rig_send(rig, COMMAND_MISSION_ITEM_ID, payload, sizeof payload);
    uint8_t bytes[2 * frame_max_bytes];
    uint8_t plan[4];
    protocol_put_i32(plan, board_plan_hil);
    size_t size = frame_encode(&frame_to_board, COMMAND_MISSION_COMMIT_ID, plan, sizeof plan, bytes, sizeof bytes);
    const size_t commit = size;
    size += frame_of(COMMAND_HIL_LOAD_GANDO_ID, bytes + size);
    line_clear(&rig->out);
    (void)tty_receive(&tty, bytes, size, 0);
    assert_int_equal(shell.request, shell_asks_store_plans);
    assert_int_equal(board_card_next(&rig->board.plans), board_keeps_hil_plan);
    assert_int_equal(rig->board.plans.hil_route, -1);
    // one that is refused asks for nothing
    shell.request = shell_asks_nothing;
    assert_true(rig_keep_plans(rig));
    hear((const char*)bytes, commit);
    assert_int_equal(shell.request, shell_asks_nothing);
}

static void a_reset_command_asks_for_a_reset_and_ends_binary_mode(void** state)
{
    (void)state;
    hear_line("#QT\n");
    uint8_t bytes[frame_max_bytes];
    hear((const char*)bytes, frame_of(COMMAND_RESET_ID, bytes));
    assert_int_equal(shell.request, shell_asks_reset);
    assert_int_equal(tty.mode, tty_text);
}

static void a_silence_gives_up_a_false_header_and_frees_the_command_behind_it(void** state)
{
    (void)state;
    hear_line("#QT\n");
    // The beginning of a command of 76 bytes, then a whole short one.
    uint8_t bytes[8 + frame_max_bytes] = {'#', 'Q', 'T', ',', COMMAND_XPLANE_INFO_ID};
    const size_t size = 8 + frame_of(COMMAND_GPS_ON_ID, bytes + 8);
    hear((const char*)bytes, size);
    tty_tick(&tty, rig->now_ms + tty_silence_ms - 1);
    assert_false(rig->board.schedule.on[telemetry_gps]);
    tty_tick(&tty, rig->now_ms + tty_silence_ms);
    assert_true(rig->board.schedule.on[telemetry_gps]);
}

static void the_ahrs_test_sends_marked_records_until_q(void** state)
{
    (void)state;
    rig->board.measured.sensors.ahrs = (message_ahrs_t){90.0F, 2.0F, -3.0F};
    hear_line("#sim\r");
    assert_string_equal(answer(), "");
    hear("#s00", 5);
    assert_string_equal(answer(), "#SYNCH00\n\r");
    assert_int_equal(tty_wait_ms(&tty), tty_ahrs_period_ms);
    tty_tick(&tty, rig->now_ms + tty_ahrs_period_ms);
    static const uint8_t record[16] = {0xAA, 0xAA, 0xAA, 0xAA, 0, 0, 0xB4, 0x42, 0, 0, 0, 0x40, 0, 0, 0x40, 0xC0};
    assert_int_equal(tty.reply.size, sizeof record);
    assert_memory_equal(reply, record, sizeof record);
    tty.reply.size = 0;
    hear_line("xyq");
    assert_int_equal(tty.mode, tty_text);
    tty_tick(&tty, rig->now_ms + 10 * tty_ahrs_period_ms);
    assert_int_equal(tty.reply.size, 0);
}

static void no_record_is_sent_of_an_attitude_that_is_not_known(void** state)
{
    (void)state;
    rig->board.measured.sensors.ahrs = (message_ahrs_t){NAN, 2.0F, -3.0F};
    hear_line("#sim\r");
    hear("#s00", 5);
    assert_string_equal(answer(), "#SYNCH00\n\r");
    tty_tick(&tty, rig->now_ms + tty_ahrs_period_ms);
    assert_int_equal(tty.reply.size, 0);
}

static void random_bytes_never_do_harm_and_never_hide_the_next_line(void** state)
{
    (void)state;
    uint32_t seed = 1;
    for (int round = 0; round < 2000; round++)
    {
        char noise[64];
        for (size_t i = 0; i < sizeof noise; i++)
        {
            seed = seed * 1664525U + 1013904223U;
            noise[i] = (char)(seed >> 24U);
        }
        hear(noise, sizeof noise);
        tty_tick(&tty, rig->now_ms += 20);
        tty.reply.size = 0;
        shell.request = shell_asks_nothing;
    }
    hear_line("q\n");
    tty.mode = tty_text;
    tty.reply.size = 0;
    hear_line("\nversion\n");
    assert_string_equal(answer(), "\r" BOARD_FIRMWARE_NAME " " BOARD_FIRMWARE_VERSION "\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_line_is_answered_when_it_ends, start),
        cmocka_unit_test_setup(bytes_are_taken_up_to_the_end_of_a_line, start),
        cmocka_unit_test_setup(the_greeting_opens_binary_mode_in_any_pieces, start),
        cmocka_unit_test_setup(the_exit_command_gives_text_mode_back_and_what_follows_it_is_text, start),
        cmocka_unit_test_setup(a_request_stops_the_reading_and_nothing_behind_it_is_lost, start),
        cmocka_unit_test_setup(a_committed_plan_is_to_be_stored_before_the_next_command_is_done, start),
        cmocka_unit_test_setup(without_a_card_the_board_itself_refuses_to_store, start),
        cmocka_unit_test_setup(a_reset_command_asks_for_a_reset_and_ends_binary_mode, start),
        cmocka_unit_test_setup(a_silence_gives_up_a_false_header_and_frees_the_command_behind_it, start),
        cmocka_unit_test_setup(the_ahrs_test_sends_marked_records_until_q, start),
        cmocka_unit_test_setup(no_record_is_sent_of_an_attitude_that_is_not_known, start),
        cmocka_unit_test_setup(random_bytes_never_do_harm_and_never_hide_the_next_line, start),
    };
    return cmocka_run_group_tests_name("app.tty", tests, NULL, NULL);
}
