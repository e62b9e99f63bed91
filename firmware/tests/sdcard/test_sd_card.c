#include "support/cmocka_all.h"

#include <string.h>

#include "sdcard/sd_bus.h"
#include "sdcard/sd_card.h"
#include "support/sd_model.h"
#include "volume/volume.h"

enum
{
    block_bytes = 4096,
    blocks = 64,
    sector_bytes = sd_model_sector_bytes,
    longest_pauses = 2000, ///< that any single call may take
    long_bytes = 2400
};

static sd_model_t model;
static sd_model_t before;
static sd_card_t card;
static volume_t volume;

/// The board starts, with the card as it is.
static void start_board(void)
{
    sd_card_init(&card, &model.spi, block_bytes, blocks);
    volume_init(&volume, &card.device, NULL);
    model.pauses = 1;
    model.bytes = 0;
}

static int start(void** state)
{
    (void)state;
    sd_model_init(&model);
    start_board();
    return 0;
}

/// What went over the bus was by the rules, and nothing took too long.
static int finish(void** state)
{
    (void)state;
    assert_int_equal(model.bad_crcs, 0);
    assert_int_equal(model.too_fast, 0);
    assert_true(model.pauses < longest_pauses);
    return 0;
}

static block_status_t begin(void)
{
    return card.device.begin(card.device.context);
}

static const uint8_t* content(uint8_t seed, size_t size)
{
    static uint8_t bytes[block_bytes];
    for (size_t i = 0; i < size; i++)
    {
        bytes[i] = (uint8_t)(i * 7U + i / 512U + seed);
    }
    return bytes;
}

static block_status_t write(uint32_t block, uint32_t offset, uint8_t seed, size_t size)
{
    return card.device.program(card.device.context, block, offset, content(seed, size), size);
}

static block_status_t read(uint32_t block, uint32_t offset, uint8_t* data, size_t size)
{
    return card.device.read(card.device.context, block, offset, data, size);
}

static bool holds(uint32_t block, uint32_t offset, uint8_t seed, size_t size)
{
    static uint8_t data[block_bytes];
    return read(block, offset, data, size) == block_ok && memcmp(data, content(seed, size), size) == 0;
}

static void assert_keeps_what_is_written(void)
{
    assert_int_equal(begin(), block_ok);
    assert_true(model.is_fast);
    assert_int_equal(card.device.erase(card.device.context, 2), block_ok);
    assert_int_equal(write(2, 1024, 1, 1536), block_ok);
    assert_int_equal(write(blocks - 1, 0, 2, block_bytes), block_ok);
    assert_int_equal(card.device.sync(card.device.context), block_ok);
    assert_true(holds(2, 1024, 1, 1536));
    assert_true(holds(blocks - 1, 0, 2, block_bytes));
    assert_memory_equal(model.sectors[2 * 8 + 2], content(1, 1536), sector_bytes);
    assert_int_equal(model.writes, 3 + 8);
}

static void a_card_of_high_capacity_keeps_what_is_written(void** state)
{
    (void)state;
    assert_keeps_what_is_written();
}

static void a_card_of_standard_capacity_keeps_what_is_written(void** state)
{
    (void)state;
    model.is_high_capacity = false;
    assert_keeps_what_is_written();
}

static void a_card_of_the_first_version_keeps_what_is_written(void** state)
{
    (void)state;
    model.is_high_capacity = false;
    model.is_first_version = true;
    assert_keeps_what_is_written();
}

static void nothing_is_sent_before_the_device_is_used(void** state)
{
    (void)state;
    uint8_t data[sector_bytes];
    assert_int_equal(read(0, 0, data, sizeof data), block_failed);
    assert_int_equal(write(0, 0, 1, sector_bytes), block_failed);
    assert_int_equal(card.device.erase(card.device.context, 0), block_failed);
    assert_int_equal(card.device.sync(card.device.context), block_failed);
    assert_int_equal(model.bytes, 0);
}

static void a_card_that_is_there_already_is_not_identified_again(void** state)
{
    (void)state;
    assert_int_equal(begin(), block_ok);
    const long bytes = model.bytes;
    assert_int_equal(begin(), block_ok);
    assert_true(model.bytes - bytes < 32);
}

/// Each of these makes a card that cannot be used.
static void a_card_that_cannot_be_used_is_a_failure(void** state)
{
    (void)state;
    for (int kind = 0; kind < 11; kind++)
    {
        (void)start(state);
        model.is_absent = kind == 0;
        model.is_line_low = kind == 1;
        model.bus_fails_from = kind == 2 ? 1 : 0;
        model.stays_idle = kind == 3;
        model.has_other_voltage = kind == 4;
        model.refuses_crc = kind == 5;
        model.has_no_token = kind == 6;
        model.damaged_reads = kind == 7 ? sd_model_always : 0;
        model.csd_version = kind == 8 ? 3 : 0xFF;
        model.damaged_commands = kind == 9 ? sd_model_always : 0;
        model.is_high_capacity = kind != 10;
        model.told_sectors = kind == 10 ? blocks * 8 - 4 : 0;
        assert_int_equal(begin(), block_failed);
        uint8_t data[sector_bytes];
        assert_int_equal(read(0, 0, data, sizeof data), block_failed);
        assert_int_equal(model.writes, 0);
        (void)finish(state);
    }
}

static void a_card_that_first_does_not_hear_is_asked_again(void** state)
{
    (void)state;
    model.deaf_idles = 3;
    assert_int_equal(begin(), block_ok);
}

static void damage_on_the_way_is_tried_again(void** state)
{
    (void)state;
    assert_int_equal(begin(), block_ok);
    model.damaged_writes = 2;
    assert_int_equal(write(1, 0, 1, sector_bytes), block_ok);
    model.damaged_commands = 1;
    assert_int_equal(write(1, 512, 2, sector_bytes), block_ok);
    model.damaged_reads = 2;
    assert_true(holds(1, 0, 1, sector_bytes));
    model.damaged_commands = 2;
    assert_true(holds(1, 512, 2, sector_bytes));
}

static void a_line_that_damages_everything_is_a_failure(void** state)
{
    (void)state;
    uint8_t data[sector_bytes];
    assert_int_equal(begin(), block_ok);
    model.damaged_reads = sd_model_always;
    assert_int_equal(read(0, 0, data, sizeof data), block_failed);
    model.damaged_reads = 0;
    assert_int_equal(begin(), block_ok);
    model.damaged_writes = sd_model_always;
    assert_int_equal(write(0, 0, 1, sector_bytes), block_failed);
    assert_int_equal(model.writes, 0);
}

static void a_worn_sector_is_told_and_the_card_goes_on(void** state)
{
    (void)state;
    uint8_t data[sector_bytes];
    assert_int_equal(begin(), block_ok);
    model.is_worn[8] = true;
    assert_int_equal(write(1, 0, 1, sector_bytes), block_worn);
    model.is_unreadable[9] = true;
    assert_int_equal(read(1, 512, data, sizeof data), block_worn);
    assert_int_equal(write(1, 1024, 1, sector_bytes), block_ok);
}

static void a_locked_card_is_a_failure(void** state)
{
    (void)state;
    assert_int_equal(begin(), block_ok);
    model.is_locked = true;
    assert_int_equal(write(1, 0, 1, sector_bytes), block_failed);
    model.is_worn[8] = true;
    assert_int_equal(write(1, 0, 1, sector_bytes), block_failed);
}

static void a_card_that_stays_busy_is_a_failure_and_not_waited_for_again(void** state)
{
    (void)state;
    assert_int_equal(begin(), block_ok);
    model.stays_busy = true;
    assert_int_equal(write(1, 0, 1, sector_bytes), block_failed);
    const long pauses = model.pauses;
    assert_int_equal(write(1, 512, 1, sector_bytes), block_failed);
    assert_int_equal(model.pauses, pauses);
}

static void a_sector_beyond_the_card_is_a_failure(void** state)
{
    (void)state;
    assert_int_equal(begin(), block_ok);
    assert_int_equal(write(blocks, 0, 1, sector_bytes), block_failed);
    assert_int_equal(begin(), block_ok);
    uint8_t data[sector_bytes];
    assert_int_equal(read(blocks, 0, data, sizeof data), block_failed);
    assert_int_equal(begin(), block_ok);
    assert_int_equal(card.device.erase(card.device.context, blocks), block_failed);
}

static void a_card_pulled_out_at_any_byte_fails_and_one_put_in_is_used_from_the_next_beginning(void** state)
{
    (void)state;
    assert_int_equal(begin(), block_ok);
    for (long at = 0; at < 560; at++)
    {
        model.bytes_until_pulled = at;
        const block_status_t status = write(1, 0, (uint8_t)at, sector_bytes);
        assert_true(model.is_absent);
        assert_int_equal(status, block_failed);
        // Another card takes its place while the file system still believes in the first.
        sd_model_restart(&model);
        const long writes = model.writes;
        assert_int_equal(write(1, 512, 1, sector_bytes), block_failed);
        assert_int_equal(model.writes, writes);
        model.pauses = 1;
        assert_int_equal(begin(), block_ok);
        assert_int_equal(write(1, 512, 1, sector_bytes), block_ok);
    }
}

/// The board restarts, the card does not: what the start sends becomes the rest of the block.
static void a_write_that_a_restart_cuts_in_two_never_counts(void** state)
{
    (void)state;
    assert_int_equal(begin(), block_ok);
    assert_int_equal(write(1, 0, 1, sector_bytes), block_ok);
    const uint8_t half[1 + sector_bytes / 2] = {0xFE};
    assert_int_equal(sd_bus_command(&model.spi, 24, 8, NULL, 0), sd_answer_ready);
    assert_true(model.spi.exchange(model.spi.context, half, NULL, sizeof half));
    start_board();
    assert_int_equal(begin(), block_ok);
    assert_true(holds(1, 0, 1, sector_bytes));
    assert_int_equal(model.bad_crcs, 1);
    model.bad_crcs = 0;
    model.too_fast = 0;
}

static bool put(const char* name, uint8_t seed, size_t size)
{
    return volume.storage.replace(volume.storage.context, name, content(seed, size), size) == storage_ok;
}

static bool has(const char* name, uint8_t seed, size_t size)
{
    uint8_t data[long_bytes];
    size_t found = 0;
    return volume.storage.read(volume.storage.context, name, data, sizeof data, &found) == storage_ok &&
           found == size && memcmp(data, content(seed, size), size) == 0;
}

static storage_status_t look(const char* name)
{
    uint8_t data[16];
    size_t found = 0;
    return volume.storage.read(volume.storage.context, name, data, sizeof data, &found);
}

static void files_outlive_the_power(void** state)
{
    (void)state;
    memset(model.sectors, 0, sizeof model.sectors);
    assert_int_equal(look("a"), storage_missing);
    assert_int_equal(model.writes, 0);
    assert_true(put("a", 1, 92));
    assert_true(put("b", 2, long_bytes));
    sd_model_restart(&model);
    start_board();
    assert_true(has("a", 1, 92));
    assert_true(has("b", 2, long_bytes));
}

static void without_a_card_there_are_no_files_until_one_is_plugged_in(void** state)
{
    (void)state;
    model.is_absent = true;
    assert_int_equal(look("a"), storage_failed);
    assert_false(put("a", 1, 92));
    sd_model_restart(&model);
    assert_true(put("a", 1, 92));
    assert_true(has("a", 1, 92));
}

static void a_card_of_a_camera_is_a_failure_until_something_is_stored(void** state)
{
    (void)state;
    for (size_t i = 0; i < sizeof model.sectors; i++)
    {
        model.sectors[i / sector_bytes][i % sector_bytes] = (uint8_t)(i % 251);
    }
    assert_int_equal(look("a"), storage_failed);
    assert_int_equal(model.writes, 0);
    assert_true(put("a", 1, 92));
    assert_true(has("a", 1, 92));
}

static void worn_sectors_are_gone_around(void** state)
{
    (void)state;
    assert_true(put("a", 1, 92));
    for (size_t sector = 16; sector < 40; sector++)
    {
        model.is_worn[sector] = true;
    }
    for (uint8_t seed = 0; seed < 20; seed++)
    {
        assert_true(put("b", seed, long_bytes));
        assert_true(has("b", seed, long_bytes));
    }
    assert_true(has("a", 1, 92));
    model.pauses = 0;
}

/// The old or the new file is there and the other one as it was, wherever the power is cut and whatever that leaves.
static void a_power_cut_leaves_the_old_file_or_the_new_one(void** state)
{
    (void)state;
    for (uint8_t uses = 0; uses < 5; uses++)
    {
        (void)start(state);
        for (uint8_t i = 0; i <= uses; i++)
        {
            assert_true(put("a", 1, 92));
            assert_true(put("b", 2, long_bytes));
        }
        before = model;
        const long begun = model.writes;
        assert_true(put("b", 3, long_bytes));
        const long writes = model.writes - begun;
        assert_true(writes > 5);
        for (long at = 0; at < writes * sd_cut_count; at++)
        {
            model = before;
            sd_model_restart(&model);
            start_board();
            model.writes_until_cut = at / sd_cut_count;
            model.cut = (sd_cut_t)(at % sd_cut_count);
            assert_false(put("b", 3, long_bytes));
            sd_model_restart(&model);
            start_board();
            assert_true(has("b", 2, long_bytes) != has("b", 3, long_bytes));
            assert_true(has("a", 1, 92));
            assert_true(put("b", 4, long_bytes));
            assert_true(has("b", 4, long_bytes));
            assert_true(has("a", 1, 92));
        }
    }
    model.pauses = 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_card_of_high_capacity_keeps_what_is_written, start, finish),
        cmocka_unit_test_setup_teardown(a_card_of_standard_capacity_keeps_what_is_written, start, finish),
        cmocka_unit_test_setup_teardown(a_card_of_the_first_version_keeps_what_is_written, start, finish),
        cmocka_unit_test_setup_teardown(nothing_is_sent_before_the_device_is_used, start, finish),
        cmocka_unit_test_setup_teardown(a_card_that_is_there_already_is_not_identified_again, start, finish),
        cmocka_unit_test_setup_teardown(a_card_that_cannot_be_used_is_a_failure, start, finish),
        cmocka_unit_test_setup_teardown(a_card_that_first_does_not_hear_is_asked_again, start, finish),
        cmocka_unit_test_setup_teardown(damage_on_the_way_is_tried_again, start, finish),
        cmocka_unit_test_setup_teardown(a_line_that_damages_everything_is_a_failure, start, finish),
        cmocka_unit_test_setup_teardown(a_worn_sector_is_told_and_the_card_goes_on, start, finish),
        cmocka_unit_test_setup_teardown(a_locked_card_is_a_failure, start, finish),
        cmocka_unit_test_setup_teardown(a_card_that_stays_busy_is_a_failure_and_not_waited_for_again, start, finish),
        cmocka_unit_test_setup_teardown(a_sector_beyond_the_card_is_a_failure, start, finish),
        cmocka_unit_test_setup_teardown(
            a_card_pulled_out_at_any_byte_fails_and_one_put_in_is_used_from_the_next_beginning, start, finish),
        cmocka_unit_test_setup_teardown(a_write_that_a_restart_cuts_in_two_never_counts, start, finish),
        cmocka_unit_test_setup_teardown(files_outlive_the_power, start, finish),
        cmocka_unit_test_setup_teardown(without_a_card_there_are_no_files_until_one_is_plugged_in, start, finish),
        cmocka_unit_test_setup_teardown(a_card_of_a_camera_is_a_failure_until_something_is_stored, start, finish),
        cmocka_unit_test_setup_teardown(worn_sectors_are_gone_around, start, finish),
        cmocka_unit_test_setup_teardown(a_power_cut_leaves_the_old_file_or_the_new_one, start, finish),
    };
    return cmocka_run_group_tests_name("sdcard.sd_card", tests, NULL, NULL);
}
