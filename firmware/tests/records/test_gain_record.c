#include "support/cmocka_all.h"

#include <string.h>

#include "records/gain_record.h"
#include "records/record_store.h"
#include "support/card.h"

static card_t card;
static uint8_t room[128];

static int start(void** state)
{
    (void)state;
    card_init(&card);
    return 0;
}

static void store_two(void)
{
    assert_int_equal(gain_record_put(room, 0, "first", 1.5F), 8);
    const size_t taken = gain_record_put(room, 1, "second", -2.5F);
    assert_int_equal(taken, 16);
    assert_int_equal(gain_record_save(&card.storage, room, sizeof room, taken), record_whole);
}

static void values_are_found_by_their_names(void** state)
{
    (void)state;
    store_two();
    size_t count = 0;
    assert_int_equal(gain_record_load(&card.storage, room, sizeof room, &count), record_whole);
    assert_int_equal(count, 2);
    float value = 7.0F;
    assert_false(gain_record_find(room, count, "third", &value));
    assert_close(value, 7.0, 0.0);
    assert_true(gain_record_find(room, count, "second", &value));
    assert_close(value, -2.5, 0.0);
    assert_true(gain_record_find(room, count, "first", &value));
    assert_close(value, 1.5, 0.0);
}

static void an_empty_card_has_none(void** state)
{
    (void)state;
    size_t count = 3;
    assert_int_equal(gain_record_load(&card.storage, room, sizeof room, &count), record_absent);
}

static void a_damaged_record_is_told(void** state)
{
    (void)state;
    size_t count = 0;
    for (size_t byte = 0; byte < (size_t)record_frame_bytes + 16; byte++)
    {
        card_init(&card);
        store_two();
        card.files[0].data[byte] ^= 0x01;
        assert_int_equal(gain_record_load(&card.storage, room, sizeof room, &count), record_damaged);
    }
}

static void half_a_gain_and_another_version_are_damage(void** state)
{
    (void)state;
    size_t count = 0;
    (void)gain_record_put(room, 0, "first", 1.5F);
    assert_int_equal(gain_record_save(&card.storage, room, sizeof room, 12), record_whole);
    assert_int_equal(gain_record_load(&card.storage, room, sizeof room, &count), record_damaged);
    card_init(&card);
    const record_kind_t before = {.name = "gains", .magic = 0x46474550U, .version = 0U};
    (void)gain_record_put(room, 0, "first", 1.5F);
    assert_int_equal(record_save(&card.storage, &before, room, sizeof room, 8), record_whole);
    assert_int_equal(gain_record_load(&card.storage, room, sizeof room, &count), record_damaged);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(values_are_found_by_their_names, start),
        cmocka_unit_test_setup(an_empty_card_has_none, start),
        cmocka_unit_test_setup(a_damaged_record_is_told, start),
        cmocka_unit_test_setup(half_a_gain_and_another_version_are_damage, start),
    };
    return cmocka_run_group_tests_name("records.gain_record", tests, NULL, NULL);
}
