#include "support/cmocka_all.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "common/bytes.h"
#include "common/crc32.h"
#include "flight/description.h"
#include "flight/own_gains.h"
#include "flight/own_topics.h"
#include "support/rig.h"

enum
{
    gain_head = 20, ///< length, kind, type, flags, minimum, maximum, step, default
    topic_head = 6,
    field_head = 15
};

/// The texts of a row follow its numbers, each ended by a zero; returns where the next one begins.
static const char* assert_text(const char* found, const char* text)
{
    assert_string_equal(found, text);
    return found + strlen(text) + 1;
}

/// A row, which is whole: its length is its first byte.
static size_t row_of(size_t number, uint8_t row[description_row_max_bytes])
{
    memset(row, 0xEE, description_row_max_bytes);
    const size_t size = description_row(number, row);
    assert_true(size > 2);
    assert_int_equal(row[0], size);
    return size;
}

static void every_gain_has_a_row_and_its_name_is_its_own(void** state)
{
    (void)state;
    for (size_t number = 0; number < own_gains_count(); number++)
    {
        uint8_t row[description_row_max_bytes];
        const size_t size = row_of(number, row);
        own_gain_t gain;
        assert_true(own_gains_describe(number, &gain));
        assert_int_equal(row[1], 1);
        assert_int_equal(row[2], gain.choices[0] != '\0' ? 5 : 1);
        assert_int_equal(row[3], 0);
        assert_close(bytes_read_f32(row + 4), gain.minimum, 0.0);
        assert_close(bytes_read_f32(row + 8), gain.maximum, 0.0);
        assert_close(bytes_read_f32(row + 12), gain.step, 0.0);
        assert_close(bytes_read_f32(row + 16), gain.default_value, 0.0);
        assert_true(gain.minimum <= gain.default_value && gain.default_value <= gain.maximum && gain.step > 0.0F);
        const char* text = assert_text((const char*)row + gain_head, gain.name);
        text = assert_text(text, gain.unit);
        text = assert_text(text, gain.group);
        text = assert_text(text, gain.choices);
        text = assert_text(text, gain.help);
        assert_ptr_equal(text, row + size);
        for (const char* letter = gain.name; *letter != '\0'; letter++)
        {
            assert_true(islower(*letter) || isdigit(*letter) || *letter == '_');
        }
        for (size_t other = 0; other < number; other++)
        {
            own_gain_t before;
            assert_true(own_gains_describe(other, &before));
            assert_string_not_equal(before.name, gain.name);
        }
    }
}

static void the_topics_follow_the_gains_each_with_its_fields(void** state)
{
    (void)state;
    size_t number = own_gains_count();
    uint8_t row[description_row_max_bytes];
    for (size_t i = 0; i < own_topic_count; i++)
    {
        const own_topic_t* const topic = own_topics_definition((own_topic_id_t)i);
        size_t size = row_of(number, row);
        number++;
        assert_int_equal(row[1], 2);
        assert_int_equal(row[2] | row[3] << 8, topic->type_word);
        assert_int_equal(row[4] | row[5] << 8, topic->period_ms);
        const char* text = assert_text((const char*)row + topic_head, topic->name);
        text = assert_text(text, topic->help);
        assert_ptr_equal(text, row + size);
        for (size_t j = 0; j < topic->field_count; j++)
        {
            const own_topic_field_t* const field = &topic->fields[j];
            size = row_of(number, row);
            number++;
            assert_int_equal(row[1], 3);
            assert_int_equal(row[2], field->type);
            assert_close(bytes_read_f32(row + 3), 1.0, 0.0);
            assert_close(bytes_read_f32(row + 7), field->minimum, 0.0);
            assert_close(bytes_read_f32(row + 11), field->maximum, 0.0);
            text = assert_text((const char*)row + field_head, field->name);
            text = assert_text(text, field->unit);
            text = assert_text(text, "");
            text = assert_text(text, field->sign);
            assert_ptr_equal(text, row + size);
        }
    }
    assert_int_equal(number, 29);
    assert_int_equal(description_row(number, row), 0);
    assert_int_equal(description_row(SIZE_MAX, row), 0);
}

static void the_law_is_a_choice_between_texts_and_a_gain_is_a_number(void** state)
{
    (void)state;
    uint8_t row[description_row_max_bytes];
    (void)row_of(0, row);
    const char* text = assert_text((const char*)row + gain_head, "guidance_law");
    text = assert_text(text, "1");
    text = assert_text(text, "guidance");
    (void)assert_text(text, "deployed|line");
    (void)row_of(1, row);
    text = assert_text((const char*)row + gain_head, "line_bank_limit");
    (void)assert_text(text, "deg");
}

static void the_blocks_are_the_rows_one_after_the_other_with_zeros_behind_the_end(void** state)
{
    (void)state;
    uint8_t table[8192] = {0};
    size_t size = 0;
    for (size_t number = 0; description_row(number, table + size) > 0; number++)
    {
        size += table[size];
    }
    const description_summary_t summary = description_summary();
    assert_int_equal(summary.size, size);
    assert_int_equal(summary.crc32, crc32_of(table, size));
    memset(table + size, 0, sizeof table - size);
    const size_t blocks = (size + description_block_bytes - 1) / description_block_bytes;
    uint8_t block[description_block_bytes];
    for (size_t number = 0; number < blocks; number++)
    {
        memset(block, 0xEE, sizeof block);
        assert_true(description_block(number, block));
        assert_memory_equal(block, table + number * sizeof block, sizeof block);
    }
    assert_false(description_block(blocks, block));
}

static message_description_t told_description(rig_t* rig)
{
    message_description_t told;
    assert_int_equal(rig_ask(rig, COMMAND_DESCRIBE_ID, NULL, 0), command_done);
    message_description_unpack(&told, line_newest(&rig->out, MESSAGE_DESCRIPTION_ID)->payload);
    return told;
}

static int32_t block_count(rig_t* rig)
{
    return (told_description(rig).table_size + description_block_bytes - 1) / description_block_bytes;
}

static void a_station_reads_the_blocks_one_a_tick_and_finds_their_checksum(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    const message_description_t told = told_description(rig);
    const int32_t blocks = block_count(rig);
    uint32_t crc = 0;
    for (int32_t first = 0; first < blocks; first += 8)
    {
        const int32_t count = blocks - first < 8 ? blocks - first : 8;
        assert_int_equal(rig_ask_with_two(rig, COMMAND_DESCRIBE_BLOCKS_ID, first, count), command_done);
        for (int32_t i = 0; i < count; i++)
        {
            line_clear(&rig->out);
            assert_int_equal(board_tick(&rig->board, rig->now_ms), i + 1 < count);
            assert_int_equal(line_count_of(&rig->out, MESSAGE_DESCRIPTION_BLOCK_ID), 1);
            const line_frame_t* const frame = line_newest(&rig->out, MESSAGE_DESCRIPTION_BLOCK_ID);
            assert_int_equal(protocol_get_i32(frame->payload), first + i);
            const size_t rest = (size_t)(told.table_size - (first + i) * description_block_bytes);
            crc = crc32_with(crc, frame->payload + 4, rest < description_block_bytes ? rest : description_block_bytes);
        }
    }
    assert_int_equal(crc, told.table_crc32);
    line_clear(&rig->out);
    assert_false(board_tick(&rig->board, rig->now_ms));
    assert_int_equal(line_count_of(&rig->out, MESSAGE_DESCRIPTION_BLOCK_ID), 0);
}

static bool is_idle = true;

static bool line_is_idle(const void* context)
{
    (void)context;
    return is_idle;
}

static void a_busy_line_gets_a_block_each_half_second(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    rig->board.line.is_idle = line_is_idle;
    is_idle = false;
    assert_int_equal(rig_ask_with_two(rig, COMMAND_DESCRIBE_BLOCKS_ID, 0, 8), command_done);
    line_clear(&rig->out);
    for (int i = 0; i < 500; i++)
    {
        (void)board_tick(&rig->board, rig->now_ms);
        assert_int_equal(line_count_of(&rig->out, MESSAGE_DESCRIPTION_BLOCK_ID), (i + 1) / 50 < 8 ? (i + 1) / 50 : 8);
    }
    is_idle = true;
    assert_int_equal(rig_ask_with_two(rig, COMMAND_DESCRIBE_BLOCKS_ID, 0, 1), command_done);
    (void)board_tick(&rig->board, rig->now_ms);
    assert_int_equal(line_count_of(&rig->out, MESSAGE_DESCRIPTION_BLOCK_ID), 1);
}

static void a_line_that_is_opened_again_gets_no_block_that_was_asked_before(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    assert_int_equal(rig_ask_with_two(rig, COMMAND_DESCRIBE_BLOCKS_ID, 0, 8), command_done);
    board_open(&rig->board, rig->now_ms);
    line_clear(&rig->out);
    assert_false(board_tick(&rig->board, rig->now_ms));
    assert_int_equal(rig->out.count, 0);
}

static void a_block_behind_the_end_is_refused_without_an_answer(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    const int32_t blocks = block_count(rig);
    const int32_t refused[][2] = {
        {blocks, 1}, {blocks - 1, 2}, {-1, 1}, {0, 0}, {0, 9}, {0, -1}, {INT32_MAX, 1}, {INT32_MIN, 8},
    };
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++)
    {
        const int result = rig_ask_with_two(rig, COMMAND_DESCRIBE_BLOCKS_ID, refused[i][0], refused[i][1]);
        assert_int_equal(result, command_bad_value);
        assert_false(board_tick(&rig->board, rig->now_ms));
        assert_int_equal(rig->out.count, 1);
    }
}

static void a_gain_that_is_not_there_is_refused_without_an_answer(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    const int32_t absent[] = {-1, 19, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof absent / sizeof absent[0]; i++)
    {
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
    (void)rig_do_with_two(rig, COMMAND_DESCRIBE_BLOCKS_ID, 0, 1);
    (void)rig_do_with(rig, COMMAND_OWN_TOPICS_ID, 1);
    (void)board_tick(&rig->board, rig->now_ms);
    assert_int_equal(rig->out.count, 0);
    (void)set_gain(rig, 0, 1.0F);
    assert_int_equal(rig->out.count, 0);
    assert_int_equal(rig->board.tuning.gains.law, guidance_law_bearing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_gain_has_a_row_and_its_name_is_its_own),
        cmocka_unit_test(the_topics_follow_the_gains_each_with_its_fields),
        cmocka_unit_test(the_law_is_a_choice_between_texts_and_a_gain_is_a_number),
        cmocka_unit_test(the_blocks_are_the_rows_one_after_the_other_with_zeros_behind_the_end),
        cmocka_unit_test(a_station_reads_the_blocks_one_a_tick_and_finds_their_checksum),
        cmocka_unit_test(a_busy_line_gets_a_block_each_half_second),
        cmocka_unit_test(a_line_that_is_opened_again_gets_no_block_that_was_asked_before),
        cmocka_unit_test(a_block_behind_the_end_is_refused_without_an_answer),
        cmocka_unit_test(a_gain_that_is_not_there_is_refused_without_an_answer),
        cmocka_unit_test(a_gain_is_set_and_told_as_the_board_has_it_after_a_refusal_too),
        cmocka_unit_test(the_law_is_chosen_in_flight_without_a_step_in_a_surface),
        cmocka_unit_test(a_deployed_board_knows_nothing_of_it),
    };
    return cmocka_run_group_tests_name("flight.description", tests, NULL, NULL);
}
