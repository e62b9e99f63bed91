#include "support/cmocka_all.h"

#include <string.h>

#include "sdcard/sd_bus.h"
#include "support/sd_model.h"

static sd_model_t model;

/// A card that has been told to go idle.
static int start(void** state)
{
    (void)state;
    sd_model_init(&model);
    sd_bus_wake(&model.spi);
    assert_int_equal(sd_bus_command(&model.spi, 0, 0, NULL, 0), sd_answer_idle);
    sd_bus_end(&model.spi);
    return 0;
}

static void a_command_brings_its_answer_and_what_follows_it(void** state)
{
    (void)state;
    uint8_t more[4];
    assert_int_equal(sd_bus_command(&model.spi, 8, 0x1AA, more, sizeof more), sd_answer_idle);
    assert_memory_equal(more, ((uint8_t[]){0, 0, 1, 0xAA}), sizeof more);
    sd_bus_end(&model.spi);
    assert_false(model.is_selected);
    assert_int_equal(model.bad_crcs, 0);
}

static void what_does_not_answer_is_given_up_soon(void** state)
{
    (void)state;
    model.is_absent = true;
    const long before = model.bytes;
    assert_int_equal(sd_bus_command(&model.spi, 8, 0x1AA, NULL, 0), sd_answer_none);
    assert_true(model.bytes - before < 32);
    assert_int_equal(model.pauses, 0);
}

static void a_line_that_is_never_at_rest_is_given_up_while_other_tasks_run(void** state)
{
    (void)state;
    model.is_line_low = true;
    assert_int_equal(sd_bus_command(&model.spi, 13, 0, NULL, 0), sd_answer_none);
    assert_in_range(model.pauses, 250, 600);
}

static void a_bus_that_does_not_work_is_no_answer(void** state)
{
    (void)state;
    uint8_t block[sd_sector_bytes] = {0};
    model.bus_fails_from = sd_sector_bytes;
    model.pauses = 0;
    assert_int_equal(sd_bus_command(&model.spi, 55, 0, NULL, 0), sd_answer_idle);
    assert_int_equal(sd_bus_command(&model.spi, 41, 0, NULL, 0), sd_answer_ready);
    assert_int_equal(sd_bus_command(&model.spi, 17, 0, NULL, 0), sd_answer_ready);
    assert_int_equal(sd_bus_read(&model.spi, block, sizeof block), sd_silent);
    sd_bus_end(&model.spi);
    model.bus_fails_from = 1;
    assert_int_equal(sd_bus_command(&model.spi, 13, 0, NULL, 0), sd_answer_none);
    assert_int_equal(sd_bus_read(&model.spi, block, sizeof block), sd_silent);
    assert_int_equal(sd_bus_write(&model.spi, block), sd_silent);
}

static void a_block_that_never_comes_is_given_up_while_other_tasks_run(void** state)
{
    (void)state;
    uint8_t block[sd_sector_bytes];
    assert_int_equal(sd_bus_read(&model.spi, block, sizeof block), sd_silent);
    assert_in_range(model.pauses, 100, 400);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_command_brings_its_answer_and_what_follows_it, start),
        cmocka_unit_test_setup(what_does_not_answer_is_given_up_soon, start),
        cmocka_unit_test_setup(a_line_that_is_never_at_rest_is_given_up_while_other_tasks_run, start),
        cmocka_unit_test_setup(a_bus_that_does_not_work_is_no_answer, start),
        cmocka_unit_test_setup(a_block_that_never_comes_is_given_up_while_other_tasks_run, start),
    };
    return cmocka_run_group_tests_name("sdcard.sd_bus", tests, NULL, NULL);
}
