#include "support/cmocka_all.h"

#include "common/crc32.h"

static void the_published_check_value_comes_out(void** state)
{
    (void)state;
    assert_int_equal(crc32_of((const uint8_t*)"123456789", 9), 0xCBF43926U);
    assert_int_equal(crc32_of((const uint8_t*)"", 0), 0U);
}

static void any_single_flipped_bit_changes_it(void** state)
{
    (void)state;
    uint8_t bytes[88];
    for (size_t i = 0; i < sizeof bytes; i++)
    {
        bytes[i] = (uint8_t)(i * 37U);
    }
    const uint32_t whole = crc32_of(bytes, sizeof bytes);
    for (size_t bit = 0; bit < 8 * sizeof bytes; bit++)
    {
        bytes[bit / 8] ^= (uint8_t)(1U << (bit % 8));
        assert_int_not_equal(crc32_of(bytes, sizeof bytes), whole);
        bytes[bit / 8] ^= (uint8_t)(1U << (bit % 8));
    }
}

static void bytes_that_come_in_parts_have_the_crc_of_the_whole(void** state)
{
    (void)state;
    const uint8_t* const digits = (const uint8_t*)"123456789";
    for (size_t cut = 0; cut <= 9; cut++)
    {
        assert_int_equal(crc32_with(crc32_of(digits, cut), digits + cut, 9 - cut), 0xCBF43926U);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_published_check_value_comes_out),
        cmocka_unit_test(any_single_flipped_bit_changes_it),
        cmocka_unit_test(bytes_that_come_in_parts_have_the_crc_of_the_whole),
    };
    return cmocka_run_group_tests_name("common.crc32", tests, NULL, NULL);
}
