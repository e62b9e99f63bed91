#include "support/cmocka_all.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "common/crc32.h"
#include "flight/description.h"
#include "flight/own_gains.h"
#include "support/rig.h"

static message_description_row_t row_of(size_t row)
{
    uint8_t payload[MESSAGE_DESCRIPTION_ROW_SIZE];
    assert_true(description_row(row, payload));
    message_description_row_t values;
    message_description_row_unpack(&values, payload);
    return values;
}

/// The text of a field is the whole text, and the rest of the field is zero.
static void assert_text(const char* field, size_t room, const char* text)
{
    const size_t length = strlen(text);
    assert_true(length <= room);
    assert_memory_equal(field, text, length);
    for (size_t i = length; i < room; i++)
    {
        assert_int_equal(field[i], 0);
    }
}

static void every_row_is_whole_and_its_name_is_its_own(void** state)
{
    (void)state;
    for (size_t row = 0; row < description_count(); row++)
    {
        const message_description_row_t values = row_of(row);
        own_gain_t gain;
        assert_true(own_gains_describe(row, &gain));
        assert_int_equal(values.row, row);
        assert_int_equal(values.kind, MESSAGE_DESCRIPTION_ROW_KIND_GAIN);
        assert_true(values.minimum <= values.default_value && values.default_value <= values.maximum);
        assert_true(values.step > 0.0F);
        assert_text(values.name, sizeof values.name, gain.name);
        assert_text(values.unit, sizeof values.unit, gain.unit);
        assert_text(values.group, sizeof values.group, gain.group);
        assert_text(values.choices, sizeof values.choices, gain.choices);
        assert_text(values.help, sizeof values.help, gain.help);
        for (const char* letter = gain.name; *letter != '\0'; letter++)
        {
            assert_true(islower(*letter) || isdigit(*letter) || *letter == '_');
        }
        for (size_t other = 0; other < row; other++)
        {
            assert_int_not_equal(memcmp(row_of(other).name, values.name, sizeof values.name), 0);
        }
    }
    uint8_t payload[MESSAGE_DESCRIPTION_ROW_SIZE];
    assert_false(description_row(description_count(), payload));
}

static void the_law_is_a_choice_between_texts_and_a_gain_is_a_number(void** state)
{
    (void)state;
    const message_description_row_t law = row_of(0);
    assert_string_equal(law.name, "guidance_law");
    assert_string_equal(law.choices, "deployed|line");
    assert_int_equal(law.type, MESSAGE_DESCRIPTION_ROW_TYPE_ENUM);
    assert_close(law.maximum, 1.0, 0.0);
    const message_description_row_t bank = row_of(1);
    assert_string_equal(bank.name, "line_bank_limit");
    assert_string_equal(bank.unit, "deg");
    assert_string_equal(bank.choices, "");
    assert_int_equal(bank.type, MESSAGE_DESCRIPTION_ROW_TYPE_F32);
}

static void a_station_reads_the_rows_and_finds_their_checksum(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask(rig, COMMAND_DESCRIBE_ID, NULL, 0), command_done);
    message_description_t told;
    message_description_unpack(&told, line_newest(&rig->out, MESSAGE_DESCRIPTION_ID)->payload);
    assert_int_equal(told.row_count, 19);
    uint32_t crc = 0;
    for (int32_t row = 0; row < told.row_count; row++)
    {
        assert_int_equal(rig_ask_with(rig, COMMAND_DESCRIBE_ITEM_ID, row), command_done);
        const line_frame_t* const frame = line_newest(&rig->out, MESSAGE_DESCRIPTION_ROW_ID);
        assert_int_equal(protocol_get_i32(frame->payload), row);
        crc = crc32_with(crc, frame->payload, MESSAGE_DESCRIPTION_ROW_SIZE);
    }
    assert_int_equal(crc, told.table_crc32);
}

static void a_row_that_is_not_there_is_refused_without_an_answer(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    const int32_t absent[] = {-1, 19, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof absent / sizeof absent[0]; i++)
    {
        assert_int_equal(rig_ask_with(rig, COMMAND_DESCRIBE_ITEM_ID, absent[i]), command_bad_value);
        assert_int_equal(rig->out.count, 1);
        assert_int_equal(rig_ask_with(rig, COMMAND_OWN_GAIN_GET_ID, absent[i]), command_bad_value);
        assert_int_equal(rig->out.count, 1);
        assert_int_equal(rig_ask_with_two(rig, COMMAND_OWN_GAIN_SET_ID, absent[i], 0), command_bad_value);
        assert_int_equal(rig->out.count, 1);
    }
}

static float told_gain(const rig_t* rig, int32_t row)
{
    message_own_gain_t values;
    assert_int_equal(line_count_of(&rig->out, MESSAGE_OWN_GAIN_ID), 1);
    message_own_gain_unpack(&values, line_newest(&rig->out, MESSAGE_OWN_GAIN_ID)->payload);
    assert_int_equal(values.row, row);
    return values.value;
}

static int set_gain(rig_t* rig, int32_t row, float value)
{
    uint8_t payload[COMMAND_OWN_GAIN_SET_SIZE];
    const command_own_gain_set_t values = {.row = row, .value = value};
    command_own_gain_set_pack(&values, payload);
    return rig_ask(rig, COMMAND_OWN_GAIN_SET_ID, payload, sizeof payload);
}

static void a_gain_is_set_and_told_as_the_board_has_it_after_a_refusal_too(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with(rig, COMMAND_OWN_GAIN_GET_ID, 1), command_done);
    assert_close(told_gain(rig, 1), 30.0, 0.0);
    assert_int_equal(set_gain(rig, 1, 40.0F), command_done);
    assert_close(told_gain(rig, 1), 40.0, 0.0);
    const float refused[] = {61.0F, NAN, INFINITY};
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++)
    {
        assert_int_equal(set_gain(rig, 1, refused[i]), command_bad_value);
        assert_close(told_gain(rig, 1), 40.0, 0.0);
    }
    assert_close(rig->board.tuning.gains.line.follow.bank_limit_deg, 40.0, 0.0);
}

static void the_law_is_chosen_in_flight_without_a_step_in_a_surface(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID);
    (void)rig_do(rig, COMMAND_AUTOPILOT_ON_ID);
    const command_xplane_info_t info = rig_level_flight();
    message_hil_surfaces_t before = {0};
    for (int step = 0; step < 100; step++)
    {
        before = rig_fly(rig, &info);
    }
    assert_int_equal(set_gain(rig, 0, 1.0F), command_done);
    assert_close(told_gain(rig, 0), 1.0, 0.0);
    const message_hil_surfaces_t after = rig_fly(rig, &info);
    assert_int_equal(rig->board.hil.loop.law, guidance_law_line);
    assert_close(after.aileron, before.aileron, 0.1);
    assert_close(after.elevator, before.elevator, 0.1);
    assert_close(after.rudder, before.rudder, 0.1);
    assert_close(after.throttle, before.throttle, 0.05);
}

static void a_deployed_board_knows_nothing_of_it(void** state)
{
    (void)state;
    rig_t* const rig = rig_start_legacy();
    (void)rig_do(rig, COMMAND_DESCRIBE_ID);
    (void)rig_do_with(rig, COMMAND_DESCRIBE_ITEM_ID, 0);
    assert_int_equal(rig->out.count, 0);
    (void)set_gain(rig, 0, 1.0F);
    assert_int_equal(rig->out.count, 0);
    assert_int_equal(rig->board.tuning.gains.law, guidance_law_bearing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_is_whole_and_its_name_is_its_own),
        cmocka_unit_test(the_law_is_a_choice_between_texts_and_a_gain_is_a_number),
        cmocka_unit_test(a_station_reads_the_rows_and_finds_their_checksum),
        cmocka_unit_test(a_row_that_is_not_there_is_refused_without_an_answer),
        cmocka_unit_test(a_gain_is_set_and_told_as_the_board_has_it_after_a_refusal_too),
        cmocka_unit_test(the_law_is_chosen_in_flight_without_a_step_in_a_surface),
        cmocka_unit_test(a_deployed_board_knows_nothing_of_it),
    };
    return cmocka_run_group_tests_name("flight.description", tests, NULL, NULL);
}
