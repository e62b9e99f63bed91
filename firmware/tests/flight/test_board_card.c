#include "support/cmocka_all.h"

#include <string.h>

#include "flight/board_card.h"
#include "records/gain_record.h"
#include "support/rig.h"

static bool has_plan(const rig_t* rig, size_t plan, int32_t count, uint32_t seed)
{
    const plan_t* const held = &rig->board.plans.plan[plan];
    const waypoint_t last = rig_waypoint(seed, count - 1);
    return held->count == (size_t)count && memcmp(&held->waypoints[count - 1], &last, sizeof last) == 0;
}

/// The board starts anew, with the card that it has.
static rig_t* restart(rig_t* rig)
{
    return rig_start_on(&rig->card.storage);
}

/// What the board says of its card when it is asked for capabilities.
static bool tells_alarm(rig_t* rig)
{
    (void)rig_do(rig, COMMAND_CAPABILITIES_ID);
    message_capabilities_t values;
    message_capabilities_unpack(&values, line_newest(&rig->out, MESSAGE_CAPABILITIES_ID)->payload);
    return (values.features & MESSAGE_CAPABILITIES_BIT_HAS_CARD_ALARM) != 0;
}

static void uploaded_plans_outlive_a_restart(void** state)
{
    (void)state;
    rig_t* rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_upload(rig, board_plan_flight, 3, 1), command_done);
    assert_int_equal(rig_upload(rig, board_plan_hil, 100, 2), command_done);
    assert_true(rig_keep_plans(rig));
    assert_int_equal(board_card_next(&rig->board.plans), board_keeps_count);
    rig = restart(rig);
    assert_true(has_plan(rig, board_plan_flight, 3, 1));
    assert_true(has_plan(rig, board_plan_hil, 100, 2));
    assert_int_equal(rig->board.plans.hil_route, -1);
    assert_int_equal(board_card_next(&rig->board.plans), board_keeps_count);
    assert_false(tells_alarm(rig));
}

static void a_plan_that_is_not_committed_is_not_stored(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_MISSION_BEGIN_ID, board_plan_hil, 3), command_done);
    assert_int_equal(rig_ask_with(rig, COMMAND_MISSION_COMMIT_ID, board_plan_hil), command_bad_state);
    assert_int_equal(board_card_next(&rig->board.plans), board_keeps_count);
}

static void a_route_that_the_board_knows_is_not_stored_in_an_uploaded_plan_s_place(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_upload(rig, board_plan_hil, 3, 1), command_done);
    assert_int_equal(rig_ask(rig, COMMAND_HIL_LOAD_GANDO_ID, NULL, 0), command_done);
    assert_int_equal(board_card_next(&rig->board.plans), board_keeps_count);
}

static void without_a_card_an_uploaded_plan_lives_until_the_restart(void** state)
{
    (void)state;
    rig_t* const rig = rig_start_without_card();
    rig_extend(rig);
    assert_int_equal(rig_upload(rig, board_plan_hil, 3, 1), command_done);
    assert_int_equal(board_card_next(&rig->board.plans), board_keeps_count);
    assert_true(has_plan(rig, board_plan_hil, 3, 1));
    assert_false(tells_alarm(rig));
}

static void a_deployed_board_does_not_know_the_plans_of_its_card(void** state)
{
    (void)state;
    rig_t* rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_upload(rig, board_plan_hil, 3, 1), command_done);
    assert_true(rig_keep_plans(rig));
    const board_config_t config = {.legacy = true, .storage = &rig->card.storage, .send = rig->board.line.send};
    board_init(&rig->board, &config);
    assert_int_equal(rig->board.plans.plan[board_plan_hil].count, 0);
}

static void a_board_that_restarted_by_itself_has_its_parameters_and_flies_no_plan(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_parameter(rig, COMMAND_SET_K_ROLL_ID, 3.0F), command_done);
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_done);
    assert_int_equal(rig_upload(rig, board_plan_flight, 3, 1), command_done);
    assert_true(rig_keep_plans(rig));
    board_config_t config = {.may_be_in_flight = true, .storage = &rig->card.storage, .send = rig->board.line.send};
    board_init(&rig->board, &config);
    assert_int_equal(rig->board.plans.plan[board_plan_flight].count, 0);
    assert_close(rig->board.tuning.parameters.values[PARAMETER_K_ROLL], 3.0F, 0.0);
    assert_false(board_card_alarms(&rig->board.card));
    config.may_be_in_flight = false;
    board_init(&rig->board, &config);
    assert_true(has_plan(rig, board_plan_flight, 3, 1));
}

static void the_law_and_its_gains_outlive_a_restart_on_a_board_that_is_no_deployed_one(void** state)
{
    (void)state;
    rig_t* rig = rig_start();
    rig_extend(rig);
    assert_true(tuning_select_law(&rig->board.tuning, guidance_law_line));
    assert_true(tuning_set_line(&rig->board.tuning, 0, 40.0F));
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_done);
    board_config_t config = {.may_be_in_flight = true, .storage = &rig->card.storage, .send = rig->board.line.send};
    board_init(&rig->board, &config);
    assert_int_equal(rig->board.tuning.gains.law, guidance_law_line);
    assert_close(rig->board.tuning.gains.line.follow.bank_limit_deg, 40.0, 0.0);
    assert_false(board_card_alarms(&rig->board.card));
    config.legacy = true;
    board_init(&rig->board, &config);
    assert_int_equal(rig->board.tuning.gains.law, guidance_law_bearing);
    assert_close(rig->board.tuning.gains.line.follow.bank_limit_deg, 30.0, 0.0);
}

static void gains_of_other_firmware_are_taken_by_name_and_an_impossible_one_spoils_all(void** state)
{
    (void)state;
    rig_t* rig = rig_start();
    uint8_t room[64];
    (void)gain_record_put(room, 0, "of_other_firmware", 7.0F);
    const size_t taken = gain_record_put(room, 1, "line_bank_limit", 45.0F);
    assert_int_equal(gain_record_save(&rig->card.storage, room, sizeof room, taken), record_whole);
    rig = restart(rig);
    assert_false(tells_alarm(rig));
    assert_close(rig->board.tuning.gains.line.follow.bank_limit_deg, 45.0, 0.0);
    assert_close(rig->board.tuning.gains.line.follow.approach_time_s, 3.0, 0.0);
    (void)gain_record_put(room, 0, "line_approach", 5.0F);
    (void)gain_record_put(room, 1, "line_bank_limit", 90.0F);
    assert_int_equal(gain_record_save(&rig->card.storage, room, sizeof room, taken), record_whole);
    rig = restart(rig);
    assert_true(tells_alarm(rig));
    assert_close(rig->board.tuning.gains.line.follow.bank_limit_deg, 30.0, 0.0);
    assert_close(rig->board.tuning.gains.line.follow.approach_time_s, 3.0, 0.0);
}

static void damage_to_one_thing_gives_its_default_and_an_alarm_and_leaves_the_others(void** state)
{
    (void)state;
    static const char* const names[board_keeps_count] = {"params", "gains", "plan.flight", "plan.hil"};
    for (size_t damaged = 0; damaged < board_keeps_count; damaged++)
    {
        rig_t* rig = rig_start();
        rig_extend(rig);
        assert_int_equal(rig_ask_parameter(rig, COMMAND_SET_K_ROLL_ID, 3.0F), command_done);
        assert_true(tuning_select_law(&rig->board.tuning, guidance_law_line));
        assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_done);
        assert_int_equal(rig_upload(rig, board_plan_flight, 3, 1), command_done);
        assert_int_equal(rig_upload(rig, board_plan_hil, 4, 2), command_done);
        assert_true(rig_keep_plans(rig));
        card_find(&rig->card, names[damaged])->data[20] ^= 1U;
        rig = restart(rig);
        assert_true(tells_alarm(rig));
        for (size_t what = 0; what < board_keeps_count; what++)
        {
            assert_int_equal(rig->board.card.kept[what], what == damaged ? record_damaged : record_whole);
        }
        const float k_roll = rig->board.tuning.parameters.values[PARAMETER_K_ROLL];
        assert_close(k_roll, damaged == board_keeps_parameters ? 2.0F : 3.0F, 0.0);
        assert_close(rig->board.tuning.gains.autopilot.k_roll, k_roll, 0.0);
        assert_int_equal(rig->board.tuning.gains.law,
                         damaged == board_keeps_own_gains ? guidance_law_bearing : guidance_law_line);
        assert_int_equal(rig->board.plans.plan[board_plan_flight].count, damaged == board_keeps_flight_plan ? 0 : 3);
        assert_int_equal(rig->board.plans.plan[board_plan_hil].count, damaged == board_keeps_hil_plan ? 0 : 4);
    }
}

static void a_card_that_cannot_be_read_gives_all_defaults_and_an_alarm_until_it_can_be_written(void** state)
{
    (void)state;
    rig_t* rig = rig_start();
    rig->card.has_failed = true;
    rig = restart(rig);
    assert_true(tells_alarm(rig));
    assert_int_equal(rig->board.card.kept[board_keeps_hil_plan], record_unreadable);
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_storage_failed);
    assert_true(tells_alarm(rig));
    rig->card.has_failed = false;
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_done);
    assert_false(tells_alarm(rig));
    assert_int_equal(rig->board.card.kept[board_keeps_hil_plan], record_absent);
}

static void a_plan_that_cannot_be_stored_is_flown_and_alarmed_until_it_can(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    rig->card.cannot_write = true;
    assert_int_equal(rig_upload(rig, board_plan_hil, 5, 1), command_done);
    assert_false(rig_keep_plans(rig));
    assert_true(has_plan(rig, board_plan_hil, 5, 1));
    assert_true(tells_alarm(rig));
    rig->card.cannot_write = false;
    assert_int_equal(rig_upload(rig, board_plan_hil, 5, 2), command_done);
    assert_true(rig_keep_plans(rig));
    assert_false(tells_alarm(rig));
}

static void only_a_change_of_the_alarm_is_news(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    assert_false(board_card_note(&rig->board.card, board_keeps_parameters, record_whole));
    assert_true(board_card_note(&rig->board.card, board_keeps_hil_plan, record_unwritten));
    assert_false(board_card_note(&rig->board.card, board_keeps_parameters, record_unwritten));
    assert_false(board_card_note(&rig->board.card, board_keeps_parameters, record_whole));
    assert_true(board_card_note(&rig->board.card, board_keeps_hil_plan, record_whole));
}

static void a_card_that_does_not_answer_is_not_asked_again_at_the_start(void** state)
{
    (void)state;
    rig_t* rig = rig_start();
    rig_extend(rig);
    assert_true(tuning_set(&rig->board.tuning, 0, parameter_definitions[0].minimum));
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_done);
    board_config_t config = rig->config;
    config.card_is_silent = true;
    board_init(&rig->board, &config);
    rig_extend(rig);
    parameters_t defaults;
    parameters_init(&defaults);
    assert_memory_equal(&rig->board.tuning.parameters, &defaults, sizeof defaults);
    assert_true(tells_alarm(rig));
    // it answers again, and is used again
    assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_done);
    assert_false(tells_alarm(rig));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(uploaded_plans_outlive_a_restart),
        cmocka_unit_test(a_plan_that_is_not_committed_is_not_stored),
        cmocka_unit_test(a_route_that_the_board_knows_is_not_stored_in_an_uploaded_plan_s_place),
        cmocka_unit_test(without_a_card_an_uploaded_plan_lives_until_the_restart),
        cmocka_unit_test(a_deployed_board_does_not_know_the_plans_of_its_card),
        cmocka_unit_test(a_board_that_restarted_by_itself_has_its_parameters_and_flies_no_plan),
        cmocka_unit_test(the_law_and_its_gains_outlive_a_restart_on_a_board_that_is_no_deployed_one),
        cmocka_unit_test(gains_of_other_firmware_are_taken_by_name_and_an_impossible_one_spoils_all),
        cmocka_unit_test(damage_to_one_thing_gives_its_default_and_an_alarm_and_leaves_the_others),
        cmocka_unit_test(a_card_that_cannot_be_read_gives_all_defaults_and_an_alarm_until_it_can_be_written),
        cmocka_unit_test(a_plan_that_cannot_be_stored_is_flown_and_alarmed_until_it_can),
        cmocka_unit_test(only_a_change_of_the_alarm_is_news),
        cmocka_unit_test(a_card_that_does_not_answer_is_not_asked_again_at_the_start),
    };
    return cmocka_run_group_tests_name("flight.board_card", tests, NULL, NULL);
}
