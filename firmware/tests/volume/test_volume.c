#include "support/cmocka_all.h"

#include <string.h>

#include "support/card.h"
#include "support/flash.h"
#include "support/random.h"
#include "volume/volume.h"

enum
{
    long_bytes = 2400
};

static flash_t flash;
static uint8_t held[long_bytes];

static int start(void** state)
{
    (void)state;
    flash_init(&flash);
    return 0;
}

/// `size` bytes that differ from those of another `seed`.
static const uint8_t* content(uint8_t seed, size_t size)
{
    static uint8_t bytes[long_bytes];
    for (size_t i = 0; i < size; i++)
    {
        bytes[i] = (uint8_t)(i * 7U + seed);
    }
    return bytes;
}

static storage_status_t put(const char* name, uint8_t seed, size_t size)
{
    return flash.volume.storage.replace(flash.volume.storage.context, name, content(seed, size), size);
}

static storage_status_t take(const char* name, size_t capacity, size_t* size)
{
    return flash.volume.storage.read(flash.volume.storage.context, name, held, capacity, size);
}

static bool holds(const char* name, uint8_t seed, size_t size)
{
    size_t found = 0;
    return take(name, sizeof held, &found) == storage_ok && found == size &&
           memcmp(held, content(seed, size), size) == 0;
}

static void what_was_written_is_read(void** state)
{
    (void)state;
    assert_int_equal(put("a", 1, 92), storage_ok);
    assert_int_equal(put("b", 2, long_bytes), storage_ok);
    assert_true(holds("a", 1, 92));
    assert_true(holds("b", 2, long_bytes));
    assert_int_equal(put("b", 3, 20), storage_ok);
    flash_restart(&flash);
    assert_true(holds("a", 1, 92));
    assert_true(holds("b", 3, 20));
}

static void a_device_that_never_held_anything_has_no_files_and_is_not_written_to_by_reading(void** state)
{
    (void)state;
    size_t size = 1;
    assert_int_equal(take("a", sizeof held, &size), storage_missing);
    assert_int_equal(size, 0);
    assert_int_equal(flash.writes, 0);
    assert_int_equal(put("a", 1, 92), storage_ok);
    const long writes = flash.writes;
    assert_int_equal(take("b", sizeof held, &size), storage_missing);
    assert_true(holds("a", 1, 92));
    assert_int_equal(flash.writes, writes);
}

static void a_file_longer_than_the_room_is_told_and_its_beginning_is_read(void** state)
{
    (void)state;
    assert_int_equal(put("a", 1, long_bytes), storage_ok);
    size_t size = 0;
    assert_int_equal(take("a", 16, &size), storage_too_long);
    assert_int_equal(size, 16);
    assert_memory_equal(held, content(1, 16), 16);
}

static void rubbish_is_a_failure_until_something_is_written(void** state)
{
    (void)state;
    uint32_t noise = 1;
    for (size_t i = 0; i < sizeof flash.bytes; i++)
    {
        flash.bytes[i / flash_block_bytes][i % flash_block_bytes] = (uint8_t)random_next(&noise);
    }
    size_t size = 0;
    assert_int_equal(take("a", sizeof held, &size), storage_failed);
    assert_int_equal(flash.writes, 0);
    assert_int_equal(put("a", 1, 92), storage_ok);
    assert_true(holds("a", 1, 92));
}

static void a_device_that_does_not_answer_fails_and_keeps_what_it_has(void** state)
{
    (void)state;
    assert_int_equal(put("a", 1, 92), storage_ok);
    size_t size = 0;
    flash.cannot_read = true;
    assert_int_equal(take("a", sizeof held, &size), storage_failed);
    assert_int_equal(put("a", 2, 92), storage_failed);
    flash.cannot_read = false;
    flash.cannot_write = true;
    assert_int_equal(put("a", 2, 92), storage_failed);
    assert_true(holds("a", 1, 92));
    flash.cannot_write = false;
    assert_int_equal(put("a", 2, 92), storage_ok);
    assert_true(holds("a", 2, 92));
}

static void another_layout_is_left_as_it_is(void** state)
{
    (void)state;
    assert_int_equal(put("a", 1, 92), storage_ok);
    static flash_t as_it_was;
    as_it_was = flash;
    flash.device.block_count = flash_blocks / 2; // this firmware thinks that the card is smaller
    flash_restart(&flash);
    size_t size = 0;
    assert_int_equal(take("a", sizeof held, &size), storage_failed);
    assert_int_equal(put("a", 2, 92), storage_failed);
    assert_memory_equal(flash.bytes, as_it_was.bytes, sizeof flash.bytes);
}

static void a_full_device_refuses_and_keeps_the_old_file(void** state)
{
    (void)state;
    assert_int_equal(put("a", 1, long_bytes), storage_ok);
    char name[] = "fill0";
    while (put(name, 9, long_bytes) == storage_ok)
    {
        assert_true(name[4] < 'z');
        name[4]++;
    }
    assert_true(name[4] > '3');
    assert_int_equal(put("a", 2, long_bytes), storage_failed);
    assert_true(holds("a", 1, long_bytes));
    assert_true(holds("fill0", 9, long_bytes));
}

static void worn_blocks_are_gone_around(void** state)
{
    (void)state;
    assert_int_equal(put("a", 1, long_bytes), storage_ok);
    for (size_t block = 2; block < flash_blocks; block += 2)
    {
        flash.is_worn[block] = true;
    }
    for (uint8_t seed = 2; seed < 12; seed++)
    {
        assert_int_equal(put("a", seed, long_bytes), storage_ok);
        assert_true(holds("a", seed, long_bytes));
    }
}

static void a_block_that_lies_is_found_out_or_gone_around(void** state)
{
    (void)state;
    for (size_t block = 0; block < flash_blocks; block++)
    {
        flash_init(&flash);
        assert_int_equal(put("a", 1, long_bytes), storage_ok);
        flash.is_stuck[block] = true;
        const bool done = put("a", 2, long_bytes) == storage_ok;
        assert_true(holds("a", done ? 2 : 1, long_bytes));
    }
}

/// Whatever stands on the device: an answer, and nothing outside of the buffers (the sanitizers see to that).
static void random_damage_never_does_more_than_lose_files(void** state)
{
    (void)state;
    uint32_t noise = 7;
    long whole = 0;
    for (int round = 0; round < 600; round++)
    {
        flash_init(&flash);
        assert_int_equal(put("a", 1, 92), storage_ok);
        assert_int_equal(put("b", 2, long_bytes), storage_ok);
        for (uint32_t hit = 0; hit < 1U + random_below(&noise, 6); hit++)
        {
            // mostly where the names are
            const uint32_t block = random_below(&noise, 3) == 0 ? random_below(&noise, flash_blocks) : hit % 2U;
            flash.bytes[block][random_below(&noise, flash_block_bytes)] ^= (uint8_t)(1U << random_below(&noise, 8));
        }
        size_t size = 0;
        const storage_status_t status = take("b", sizeof held, &size);
        assert_true(size <= sizeof held);
        whole += status == storage_ok && memcmp(held, content(2, long_bytes), long_bytes) == 0 ? 1 : 0;
        if (put("a", 3, 92) == storage_ok)
        {
            assert_true(holds("a", 3, 92));
        }
    }
    assert_true(whole > 0 && whole < 600);
}

static void what_the_device_has_not_is_read_from_where_it_was_before(void** state)
{
    (void)state;
    card_t older;
    card_init(&older);
    assert_int_equal(older.storage.replace(&older, "old", content(4, 50), 50), storage_ok);
    volume_init(&flash.volume, &flash.device, &older.storage);
    assert_true(holds("old", 4, 50));
    assert_int_equal(put("a", 1, 92), storage_ok);
    assert_true(holds("old", 4, 50));
    size_t size = 0;
    assert_int_equal(take("b", sizeof held, &size), storage_missing);
    assert_int_equal(put("old", 5, 50), storage_ok);
    assert_true(holds("old", 5, 50));
    // the power was cut while the device was formatted
    memset(flash.bytes, 0x55, sizeof flash.bytes);
    assert_true(holds("old", 4, 50));
    assert_int_equal(take("b", sizeof held, &size), storage_failed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(what_was_written_is_read, start),
        cmocka_unit_test_setup(a_device_that_never_held_anything_has_no_files_and_is_not_written_to_by_reading, start),
        cmocka_unit_test_setup(a_file_longer_than_the_room_is_told_and_its_beginning_is_read, start),
        cmocka_unit_test_setup(rubbish_is_a_failure_until_something_is_written, start),
        cmocka_unit_test_setup(a_device_that_does_not_answer_fails_and_keeps_what_it_has, start),
        cmocka_unit_test_setup(another_layout_is_left_as_it_is, start),
        cmocka_unit_test_setup(a_full_device_refuses_and_keeps_the_old_file, start),
        cmocka_unit_test_setup(worn_blocks_are_gone_around, start),
        cmocka_unit_test_setup(a_block_that_lies_is_found_out_or_gone_around, start),
        cmocka_unit_test_setup(random_damage_never_does_more_than_lose_files, start),
        cmocka_unit_test_setup(what_the_device_has_not_is_read_from_where_it_was_before, start),
    };
    return cmocka_run_group_tests_name("volume.volume", tests, NULL, NULL);
}
