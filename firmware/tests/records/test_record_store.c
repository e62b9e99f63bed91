#include "support/cmocka_all.h"

#include <string.h>

#include "records/record_store.h"
#include "support/card.h"

enum
{
    payload_bytes = 20
};

static const record_kind_t kind = {.name = "thing", .magic = 0x474E4854U, .version = 2U};
static const record_kind_t newer_kind = {.name = "thing", .magic = 0x474E4854U, .version = 3U};
static card_t card;
static uint8_t room[64];
static size_t size;
static uint32_t version;

static int start(void** state)
{
    (void)state;
    card_init(&card);
    return 0;
}

static record_state_t save(const record_kind_t* as, char letter)
{
    memset(room + record_payload_offset, letter, payload_bytes);
    return record_save(&card.storage, as, room, sizeof room, payload_bytes);
}

static record_state_t load(void)
{
    return record_load(&card.storage, &kind, room, sizeof room, &size, &version);
}

static void what_was_saved_is_loaded(void** state)
{
    (void)state;
    assert_int_equal(load(), record_absent);
    assert_int_equal(save(&kind, 'a'), record_whole);
    assert_int_equal(load(), record_whole);
    assert_int_equal(size, record_frame_bytes + payload_bytes);
    assert_int_equal(version, 2);
    assert_int_equal(room[record_payload_offset], 'a');
    assert_int_equal(save(&kind, 'b'), record_whole);
    assert_int_equal(load(), record_whole);
    assert_int_equal(room[record_payload_offset + payload_bytes - 1], 'b');
    assert_int_equal(card.count, 1);
}

static void damage_is_told_and_can_be_written_over(void** state)
{
    (void)state;
    assert_int_equal(save(&kind, 'a'), record_whole);
    card.files[0].data[20] ^= 1U;
    assert_int_equal(load(), record_damaged);
    card.files[0].size = sizeof room + 1; // longer than any
    assert_int_equal(load(), record_damaged);
    assert_int_equal(save(&kind, 'b'), record_whole);
    assert_int_equal(load(), record_whole);
}

static void what_newer_firmware_wrote_is_left_as_it_is(void** state)
{
    (void)state;
    assert_int_equal(save(&newer_kind, 'n'), record_whole);
    const card_t as_it_was = card;
    assert_int_equal(load(), record_newer);
    assert_int_equal(save(&kind, 'a'), record_newer);
    assert_memory_equal(card.files, as_it_was.files, sizeof card.files);
    card.files[0].size = sizeof room + 100; // and longer than there is room for
    assert_int_equal(load(), record_newer);
    assert_int_equal(save(&kind, 'a'), record_newer);
    assert_int_equal(card.files[0].size, sizeof room + 100);
}

static void a_card_that_fails_is_told(void** state)
{
    (void)state;
    card.has_failed = true;
    assert_int_equal(load(), record_unreadable);
    assert_int_equal(save(&kind, 'a'), record_unwritten);
}

static void a_card_that_only_says_it_has_written_is_found_out(void** state)
{
    (void)state;
    card.lies = true;
    assert_int_equal(save(&kind, 'a'), record_unwritten);
    card.lies = false;
    assert_int_equal(save(&kind, 'a'), record_whole);
    card.lies = true;
    assert_int_equal(save(&kind, 'b'), record_unwritten);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(what_was_saved_is_loaded, start),
        cmocka_unit_test_setup(damage_is_told_and_can_be_written_over, start),
        cmocka_unit_test_setup(what_newer_firmware_wrote_is_left_as_it_is, start),
        cmocka_unit_test_setup(a_card_that_fails_is_told, start),
        cmocka_unit_test_setup(a_card_that_only_says_it_has_written_is_found_out, start),
    };
    return cmocka_run_group_tests_name("records.record_store", tests, NULL, NULL);
}
