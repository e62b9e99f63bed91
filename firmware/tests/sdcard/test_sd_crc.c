#include "support/cmocka_all.h"

#include <string.h>

#include "sdcard/sd_crc.h"

/// The specification's own examples (4.5).
static void commands_have_the_specification_s_checksums(void** state)
{
    (void)state;
    const uint8_t go_idle[] = {0x40, 0, 0, 0, 0};
    const uint8_t read_first[] = {0x51, 0, 0, 0, 0};
    const uint8_t condition[] = {0x48, 0, 0, 0x01, 0xAA};
    assert_int_equal(sd_crc7(go_idle, sizeof go_idle), 0x95);
    assert_int_equal(sd_crc7(read_first, sizeof read_first), 0x55);
    assert_int_equal(sd_crc7(condition, sizeof condition), 0x87);
}

static void a_block_has_the_specification_s_checksum(void** state)
{
    (void)state;
    uint8_t block[512];
    memset(block, 0xFF, sizeof block);
    assert_int_equal(sd_crc16(block, sizeof block), 0x7FA1);
    memset(block, 0, sizeof block);
    assert_int_equal(sd_crc16(block, sizeof block), 0);
    assert_int_equal(sd_crc16((const uint8_t*)"123456789", 9), 0x31C3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(commands_have_the_specification_s_checksums),
        cmocka_unit_test(a_block_has_the_specification_s_checksum),
    };
    return cmocka_run_group_tests_name("sdcard.sd_crc", tests, NULL, NULL);
}
