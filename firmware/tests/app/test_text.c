#include "support/cmocka_all.h"

#include <math.h>
#include <string.h>

#include "app/text.h"

/// What `text_add_number` makes of a value.
static const char* number(float value, unsigned int decimals)
{
    static char bytes[32];
    text_t text;
    text_init(&text, bytes, sizeof bytes - 1);
    text_add_number(&text, value, decimals);
    bytes[text.size] = '\0';
    return bytes;
}

static void numbers_are_rounded_and_lose_trailing_zeros(void** state)
{
    (void)state;
    assert_string_equal(number(0.0F, 3), "0");
    assert_string_equal(number(2.5F, 3), "2.5");
    assert_string_equal(number(-0.06F, 5), "-0.06");
    assert_string_equal(number(1.0006F, 3), "1.001");
    assert_string_equal(number(700.0F, 5), "700");
    assert_string_equal(number(99.99F, 5), "99.99");
    assert_string_equal(number(1.25F, 0), "1");
}

static void what_rounds_to_zero_has_no_sign(void** state)
{
    (void)state;
    assert_string_equal(number(-0.0004F, 3), "0");
    assert_string_equal(number(-0.0F, 3), "0");
}

static void what_is_no_number_is_a_dash(void** state)
{
    (void)state;
    assert_string_equal(number(NAN, 3), "-");
    assert_string_equal(number(INFINITY, 3), "-");
    assert_string_equal(number(-2e9F, 0), "-");
}

static void whole_numbers_are_written_to_their_limits(void** state)
{
    (void)state;
    char bytes[64];
    text_t text;
    text_init(&text, bytes, sizeof bytes);
    text_add_int(&text, INT32_MIN);
    text_add(&text, " ");
    text_add_unsigned(&text, UINT32_MAX);
    text_add(&text, " ");
    text_add_int(&text, 0);
    assert_int_equal(text.size, strlen("-2147483648 4294967295 0"));
    assert_memory_equal(bytes, "-2147483648 4294967295 0", text.size);
}

static void a_full_text_takes_nothing_more(void** state)
{
    (void)state;
    char bytes[8] = "........";
    text_t text;
    text_init(&text, bytes, 4);
    text_add(&text, "abcdefgh");
    text_pad(&text, 0, 100);
    assert_int_equal(text.size, 4);
    assert_memory_equal(bytes, "abcd....", 8);
}

static void padding_reaches_the_column_and_never_glues_words(void** state)
{
    (void)state;
    char bytes[32];
    text_t text;
    text_init(&text, bytes, sizeof bytes);
    text_add(&text, "ab");
    text_pad(&text, 0, 5);
    assert_int_equal(text.size, 5);
    text_pad(&text, 0, 3);
    assert_int_equal(text.size, 6);
}

static void words_are_read_as_numbers_only_whole(void** state)
{
    (void)state;
    float value = 7.0F;
    assert_true(text_read_number("2.5", &value));
    assert_close(value, 2.5F, 0.0);
    assert_true(text_read_number("-.25", &value));
    assert_close(value, -0.25F, 0.0);
    assert_true(text_read_number("+3.", &value));
    assert_close(value, 3.0F, 0.0);
    static const char* const wrong[] = {"", "-", ".", "1e3", "2,5", "1 ", "0x1", "nan", "1234567890", "0.1234567890"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
    {
        assert_false(text_read_number(wrong[i], &value));
    }
    assert_close(value, 3.0F, 0.0);
}

static void whole_numbers_stay_inside_of_32_bits(void** state)
{
    (void)state;
    int32_t value = 0;
    assert_true(text_read_int("2147483647", &value));
    assert_int_equal(value, INT32_MAX);
    assert_true(text_read_int("-20", &value));
    assert_int_equal(value, -20);
    assert_false(text_read_int("2147483648", &value));
    assert_false(text_read_int("12345678901", &value));
    assert_false(text_read_int("1.0", &value));
    assert_false(text_read_int("", &value));
    assert_int_equal(value, -20);
}

static void words_are_the_same_in_capitals(void** state)
{
    (void)state;
    assert_true(text_is("k_VVI", "K_vvi"));
    assert_true(text_is("", ""));
    assert_false(text_is("on", "one"));
    assert_false(text_is("one", "on"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_rounded_and_lose_trailing_zeros),
        cmocka_unit_test(what_rounds_to_zero_has_no_sign),
        cmocka_unit_test(what_is_no_number_is_a_dash),
        cmocka_unit_test(whole_numbers_are_written_to_their_limits),
        cmocka_unit_test(a_full_text_takes_nothing_more),
        cmocka_unit_test(padding_reaches_the_column_and_never_glues_words),
        cmocka_unit_test(words_are_read_as_numbers_only_whole),
        cmocka_unit_test(whole_numbers_stay_inside_of_32_bits),
        cmocka_unit_test(words_are_the_same_in_capitals),
    };
    return cmocka_run_group_tests_name("app.text", tests, NULL, NULL);
}
