#include "support/cmocka_all.h"

#include <string.h>

#include "app/shell.h"
#include "app/shell_commands.h"
#include "app/shell_reply.h"
#include "app/shell_reports.h"
#include "support/rig.h"

static rig_t* rig;
static shell_t shell;
static load_t load;
static const task_health_t health[task_count];
static uint32_t frames_dropped;
static char bytes[shell_reply_bytes + 1];

static int start(void** state)
{
    (void)state;
    static const sensors_t sensors = {NULL, NULL, NULL, NULL};
    rig = rig_start();
    shell = (shell_t){
        .board = &rig->board, .sensors = &sensors, .load = &load, .health = health, .frames_dropped = &frames_dropped};
    return 0;
}

/// What the shell says to a line.
static const char* say(const char* words)
{
    char line[128];
    (void)strncpy(line, words, sizeof line - 1);
    line[sizeof line - 1] = '\0';
    text_t reply;
    text_init(&reply, bytes, shell_reply_bytes);
    shell_run(&shell, line, &reply);
    bytes[reply.size] = '\0';
    return bytes;
}

/// Every line begins with a carriage return and ends with a line feed, and holds neither between them.
static void assert_lines_are_whole(const char* answer)
{
    while (*answer != '\0')
    {
        assert_int_equal(*answer, '\r');
        const size_t length = strcspn(answer + 1, "\r\n");
        assert_true(length < 120);
        assert_int_equal(answer[1 + length], '\n');
        answer += 2 + length;
    }
}

static void every_command_answers_in_whole_lines(void** state)
{
    (void)state;
    for (size_t i = 0; i < shell_commands_count; i++)
    {
        assert_lines_are_whole(say(shell_commands[i].words));
        char with_words[128];
        (void)strcpy(with_words, shell_commands[i].words);
        (void)strcat(with_words, " 1 on off 2 3");
        assert_lines_are_whole(say(with_words));
        shell.request = shell_asks_nothing;
    }
}

static void the_longest_answer_fits(void** state)
{
    (void)state;
    static waypoint_t far[plan_waypoints_max];
    for (size_t i = 0; i < plan_waypoints_max; i++)
    {
        far[i] = (waypoint_t){{-27.123456, -115.123456}, -1999.0F, 499.0F};
    }
    assert_true(plan_replace(&rig->board.plans.plan[board_plan_hil], far, plan_waypoints_max, false));
    const char* const answer = say("hil");
    assert_lines_are_whole(answer);
    assert_non_null(strstr(answer, "  99 "));
    assert_true(strlen(answer) < shell_reply_bytes);
}

static void an_empty_line_has_no_answer(void** state)
{
    (void)state;
    assert_string_equal(say(""), "");
    assert_string_equal(say(" \t "), "");
}

static void many_words_are_counted_and_refused(void** state)
{
    (void)state;
    assert_string_equal(say("param a b c d e f g h i j k l m n"), "\rusage: param [name [value]]\n");
    assert_string_equal(say("hil next please now and here and"), "\runknown: please (try `help`)\n");
}

static void longer_words_win_over_shorter_ones(void** state)
{
    (void)state;
    (void)say("param store");
    assert_int_equal(shell.request, shell_asks_store);
    (void)say("param load");
    assert_int_equal(shell.request, shell_asks_load);
}

static void results_of_the_card_are_told(void** state)
{
    (void)state;
    text_t reply;
    text_init(&reply, bytes, shell_reply_bytes);
    shell_tell_stored(&reply, true);
    shell_tell_stored(&reply, false);
    shell_tell_loaded(&reply, false);
    bytes[reply.size] = '\0';
    assert_string_equal(bytes, "\rok\n\rfailed: the card is missing or cannot be written\n"
                               "\rfailed: the card is missing or holds no complete set; nothing was changed\n");
}

static void what_is_wrong_with_the_card_is_told_at_the_start_and_in_the_status(void** state)
{
    (void)state;
    text_t reply;
    text_init(&reply, bytes, shell_reply_bytes);
    shell_greet(&rig->board.card, &reply);
    assert_int_equal(reply.size, 0);
    assert_non_null(strstr(say("status"), "\rcard                present\n\rcard alarm          -\n"));
    rig->board.card.kept[board_keeps_parameters] = record_unreadable;
    assert_non_null(strstr(say("status"), "\rcard                cannot be read\n"));
    rig->board.card.kept[board_keeps_parameters] = record_damaged;
    rig->board.card.kept[board_keeps_hil_plan] = record_newer;
    assert_non_null(strstr(say("status"), "\rcard alarm          parameters damaged, hil plan of newer firmware\n"));
    text_init(&reply, bytes, shell_reply_bytes);
    shell_greet(&rig->board.card, &reply);
    bytes[reply.size] = '\0';
    assert_string_equal(bytes, "\rALARM: card: parameters damaged, hil plan of newer firmware; defaults are used\n");
}

static void a_board_with_a_real_receiver_refuses_to_move_its_switches(void** state)
{
    (void)state;
    assert_string_equal(say("rc auto on"), "\rrefused: this board has a real receiver; use the transmitter\n");
}

static void a_set_parameter_reaches_the_laws(void** state)
{
    (void)state;
    (void)say("param k_rudder 0.5");
    assert_close(rig->board.tuning.gains.fly_by_wire.k_rudder, 0.5F, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(every_command_answers_in_whole_lines, start),
        cmocka_unit_test_setup(the_longest_answer_fits, start),
        cmocka_unit_test_setup(an_empty_line_has_no_answer, start),
        cmocka_unit_test_setup(many_words_are_counted_and_refused, start),
        cmocka_unit_test_setup(longer_words_win_over_shorter_ones, start),
        cmocka_unit_test_setup(results_of_the_card_are_told, start),
        cmocka_unit_test_setup(what_is_wrong_with_the_card_is_told_at_the_start_and_in_the_status, start),
        cmocka_unit_test_setup(a_board_with_a_real_receiver_refuses_to_move_its_switches, start),
        cmocka_unit_test_setup(a_set_parameter_reaches_the_laws, start),
    };
    return cmocka_run_group_tests_name("app.shell", tests, NULL, NULL);
}
