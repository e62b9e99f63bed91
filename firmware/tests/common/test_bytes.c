#include "support/cmocka_all.h"

#include "common/bytes.h"

static void the_least_significant_byte_comes_first(void** state)
{
    (void)state;
    uint8_t bytes[4];
    bytes_write_u32(bytes, 0x80000001U);
    assert_memory_equal(bytes, "\x01\x00\x00\x80", 4);
    assert_int_equal(bytes_read_u32(bytes), 0x80000001U);
}

static void a_float_is_its_ieee_754_word(void** state)
{
    (void)state;
    uint8_t bytes[4];
    bytes_write_f32(bytes, -0.5F);
    assert_memory_equal(bytes, "\x00\x00\x00\xBF", 4);
    assert_close(bytes_read_f32(bytes), -0.5F, 0.0);
}

static void an_odd_address_is_as_good_as_any(void** state)
{
    (void)state;
    uint8_t bytes[9] = {0};
    bytes_write_u32(bytes + 1, 0xA1B2C3D4U);
    bytes_write_f32(bytes + 5, 27.9319F);
    assert_int_equal(bytes_read_u32(bytes + 1), 0xA1B2C3D4U);
    assert_close(bytes_read_f32(bytes + 5), 27.9319F, 0.0);
}

static void a_double_keeps_all_its_digits(void** state)
{
    (void)state;
    uint8_t bytes[8];
    bytes_write_f64(bytes, -2.0);
    assert_memory_equal(bytes, "\x00\x00\x00\x00\x00\x00\x00\xC0", 8);
    bytes_write_f64(bytes, 27.95123456789);
    assert_true(bytes_read_f64(bytes) == 27.95123456789);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_least_significant_byte_comes_first),
        cmocka_unit_test(a_float_is_its_ieee_754_word),
        cmocka_unit_test(an_odd_address_is_as_good_as_any),
        cmocka_unit_test(a_double_keeps_all_its_digits),
    };
    return cmocka_run_group_tests_name("common.bytes", tests, NULL, NULL);
}
