#include "support/cmocka_all.h"

#include <string.h>

#include "common/bytes.h"
#include "common/crc32.h"
#include "records/record.h"

enum
{
    magic = 0x12345678,
    payload_bytes = 8,
    whole_bytes = record_frame_bytes + payload_bytes
};

static uint8_t bytes[whole_bytes + 1];
static uint32_t version;

/// A record of this version.
static void close(uint32_t of_version)
{
    memset(bytes, 0, sizeof bytes);
    memcpy(bytes + record_payload_offset, "contents", payload_bytes);
    assert_int_equal(record_close(bytes, magic, of_version, payload_bytes), whole_bytes);
}

static record_state_t open(size_t size, uint32_t newest)
{
    return record_open(bytes, size, false, magic, newest, &version);
}

static void what_was_closed_is_whole_and_tells_its_version(void** state)
{
    (void)state;
    close(2);
    assert_int_equal(open(whole_bytes, 2), record_whole);
    assert_int_equal(version, 2);
    assert_int_equal(open(whole_bytes, 5), record_whole);
    assert_int_equal(version, 2);
}

static void one_wrong_bit_anywhere_is_damage(void** state)
{
    (void)state;
    for (size_t bit = 0; bit < 8U * whole_bytes; bit++)
    {
        close(2);
        bytes[bit / 8] ^= (uint8_t)(1U << (bit % 8));
        assert_int_equal(open(whole_bytes, 2), record_damaged);
    }
}

static void every_other_length_is_damage(void** state)
{
    (void)state;
    close(2);
    for (size_t size = 0; size <= sizeof bytes; size++)
    {
        assert_int_equal(open(size, 2), size == whole_bytes ? record_whole : record_damaged);
    }
}

static void a_newer_version_is_told_from_damage(void** state)
{
    (void)state;
    close(3);
    assert_int_equal(open(whole_bytes, 2), record_newer);
    bytes[record_payload_offset] ^= 1U;
    assert_int_equal(open(whole_bytes, 2), record_damaged);
}

static void a_record_that_is_cut_off_is_newer_or_damaged(void** state)
{
    (void)state;
    close(3);
    assert_int_equal(record_open(bytes, record_frame_bytes, true, magic, 2, &version), record_newer);
    assert_int_equal(record_open(bytes, record_frame_bytes, true, magic, 3, &version), record_damaged);
    assert_int_equal(record_open(bytes, record_frame_bytes, true, magic + 1, 2, &version), record_damaged);
}

static void the_length_is_a_part_of_the_frame(void** state)
{
    (void)state;
    close(2);
    bytes_write_u32(bytes + 8, payload_bytes - 4);
    bytes_write_u32(bytes + whole_bytes - 4, crc32_of(bytes, whole_bytes - 4));
    assert_int_equal(open(whole_bytes, 2), record_damaged);
}

static void pilots_hear_of_everything_but_whole_and_absent(void** state)
{
    (void)state;
    assert_false(record_is_alarming(record_absent));
    assert_false(record_is_alarming(record_whole));
    assert_true(record_is_alarming(record_damaged));
    assert_true(record_is_alarming(record_newer));
    assert_true(record_is_alarming(record_unreadable));
    assert_true(record_is_alarming(record_unwritten));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_closed_is_whole_and_tells_its_version),
        cmocka_unit_test(one_wrong_bit_anywhere_is_damage),
        cmocka_unit_test(every_other_length_is_damage),
        cmocka_unit_test(a_newer_version_is_told_from_damage),
        cmocka_unit_test(a_record_that_is_cut_off_is_newer_or_damaged),
        cmocka_unit_test(the_length_is_a_part_of_the_frame),
        cmocka_unit_test(pilots_hear_of_everything_but_whole_and_absent),
    };
    return cmocka_run_group_tests_name("records.record", tests, NULL, NULL);
}
