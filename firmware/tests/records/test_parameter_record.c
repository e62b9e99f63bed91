#include "support/cmocka_all.h"

#include <string.h>

#include "common/bytes.h"
#include "common/crc32.h"
#include "records/parameter_record.h"
#include "support/card.h"

enum
{
    first_bytes = 16 + 4 * parameters_count + 4 ///< of a record of version 1
};

static card_t card;
static uint8_t room[parameter_record_bytes];

static int start(void** state)
{
    (void)state;
    card_init(&card);
    return 0;
}

/// A set that differs from the defaults, and from another `number`, in every value.
static parameters_t set_number(float number)
{
    parameters_t parameters;
    for (size_t i = 0; i < parameters_count; i++)
    {
        parameters.values[i] = 10.0F + number + (float)i;
    }
    return parameters;
}

static bool is_set(const parameters_t* parameters, float number)
{
    const parameters_t wanted = set_number(number);
    return memcmp(parameters, &wanted, sizeof wanted) == 0;
}

static record_state_t save(float number)
{
    const parameters_t parameters = set_number(number);
    const size_t taken = parameter_record_take(&parameters, room);
    return parameter_record_save(&card.storage, room, sizeof room, taken);
}

/// The set on the card, and the defaults where there is none.
static parameters_t load(record_state_t expected)
{
    parameters_t parameters;
    parameters_init(&parameters);
    assert_int_equal(parameter_record_load(&card.storage, &parameters, room, sizeof room), expected);
    return parameters;
}

static void assert_defaults(record_state_t expected)
{
    parameters_t defaults;
    parameters_init(&defaults);
    const parameters_t loaded = load(expected);
    assert_memory_equal(&loaded, &defaults, sizeof defaults);
}

/// One of the two files of boards before, written down here as they wrote it.
static void put_first(const char* name, uint32_t sequence, float number)
{
    uint8_t bytes[first_bytes];
    memcpy(bytes, "PEPF", 4);
    bytes_write_u32(bytes + 4, 1);
    bytes_write_u32(bytes + 8, sequence);
    bytes_write_u32(bytes + 12, 17);
    const parameters_t parameters = set_number(number);
    for (size_t i = 0; i < parameters_count; i++)
    {
        bytes_write_f32(bytes + 16 + 4 * i, parameters.values[i]);
    }
    bytes_write_u32(bytes + 84, crc32_of(bytes, 84));
    assert_int_equal(card.storage.replace(&card, name, bytes, sizeof bytes), storage_ok);
}

static void what_was_stored_is_loaded(void** state)
{
    (void)state;
    assert_defaults(record_absent);
    for (int i = 0; i < 3; i++)
    {
        assert_int_equal(save((float)i), record_whole);
        const parameters_t loaded = load(record_whole);
        assert_true(is_set(&loaded, (float)i));
    }
}

static void a_damaged_record_gives_the_defaults(void** state)
{
    (void)state;
    for (size_t byte = 0; byte < parameter_record_bytes; byte++)
    {
        card_init(&card);
        assert_int_equal(save(1.0F), record_whole);
        card.files[0].data[byte] ^= 0x01;
        assert_defaults(record_damaged);
    }
}

static void a_whole_record_with_an_impossible_value_gives_the_defaults(void** state)
{
    (void)state;
    parameters_t parameters = set_number(3.0F);
    parameters.values[0] = 1000.0F;
    const size_t taken = parameter_record_take(&parameters, room);
    assert_int_equal(parameter_record_save(&card.storage, room, sizeof room, taken), record_whole);
    assert_defaults(record_damaged);
}

static void a_record_of_another_count_gives_the_defaults(void** state)
{
    (void)state;
    const parameters_t parameters = set_number(3.0F);
    const size_t taken = parameter_record_take(&parameters, room);
    assert_int_equal(parameter_record_save(&card.storage, room, sizeof room, taken - 4), record_whole);
    assert_defaults(record_damaged);
    (void)parameter_record_take(&parameters, room);
    room[record_payload_offset] = 16;
    assert_int_equal(parameter_record_save(&card.storage, room, sizeof room, taken), record_whole);
    assert_defaults(record_damaged);
}

static void boards_before_left_two_files_of_which_the_newer_whole_one_counts(void** state)
{
    (void)state;
    put_first("params.a", 7, 1.0F);
    parameters_t loaded = load(record_whole);
    assert_true(is_set(&loaded, 1.0F));
    put_first("params.b", 8, 2.0F);
    loaded = load(record_whole);
    assert_true(is_set(&loaded, 2.0F));
    put_first("params.a", 9, 3.0F);
    loaded = load(record_whole);
    assert_true(is_set(&loaded, 3.0F));
    card_find(&card, "params.a")->data[20] ^= 1U;
    loaded = load(record_whole);
    assert_true(is_set(&loaded, 2.0F));
    card_find(&card, "params.b")->size = 3;
    assert_defaults(record_damaged);
}

static void their_order_survives_the_counter_s_wrap(void** state)
{
    (void)state;
    put_first("params.a", 0xFFFFFFFFU, 1.0F);
    put_first("params.b", 0, 2.0F);
    parameters_t loaded = load(record_whole);
    assert_true(is_set(&loaded, 2.0F));
    put_first("params.a", 0, 1.0F);
    put_first("params.b", 0xFFFFFFFFU, 2.0F);
    loaded = load(record_whole);
    assert_true(is_set(&loaded, 1.0F));
}

static void loading_them_writes_nothing_and_the_next_store_writes_today_s_record(void** state)
{
    (void)state;
    put_first("params.a", 7, 1.0F);
    const card_t as_it_was = card;
    (void)load(record_whole);
    assert_memory_equal(&card.files, &as_it_was.files, sizeof card.files);
    assert_int_equal(save(4.0F), record_whole);
    parameters_t loaded = load(record_whole);
    assert_true(is_set(&loaded, 4.0F));
    // and what is old does not come back when that is damaged
    card_find(&card, "params")->data[30] ^= 1U;
    assert_defaults(record_damaged);
}

static void a_card_that_fails_gives_the_defaults(void** state)
{
    (void)state;
    assert_int_equal(save(1.0F), record_whole);
    assert_true(parameter_record_card_answers(&card.storage));
    card.has_failed = true;
    assert_defaults(record_unreadable);
    assert_false(parameter_record_card_answers(&card.storage));
    card_init(&card);
    assert_true(parameter_record_card_answers(&card.storage));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(what_was_stored_is_loaded, start),
        cmocka_unit_test_setup(a_damaged_record_gives_the_defaults, start),
        cmocka_unit_test_setup(a_whole_record_with_an_impossible_value_gives_the_defaults, start),
        cmocka_unit_test_setup(a_record_of_another_count_gives_the_defaults, start),
        cmocka_unit_test_setup(boards_before_left_two_files_of_which_the_newer_whole_one_counts, start),
        cmocka_unit_test_setup(their_order_survives_the_counter_s_wrap, start),
        cmocka_unit_test_setup(loading_them_writes_nothing_and_the_next_store_writes_today_s_record, start),
        cmocka_unit_test_setup(a_card_that_fails_gives_the_defaults, start),
    };
    return cmocka_run_group_tests_name("records.parameter_record", tests, NULL, NULL);
}
