#include "support/cmocka_all.h"

#include <string.h>

#include "flight/line_gains.h"

static size_t index_of(const char* name)
{
    size_t index = 0;
    while (index < line_gains_count && strcmp(line_gain_definitions[index].name, name) != 0)
    {
        index++;
    }
    return index;
}

static void every_gain_has_its_own_place_and_a_default_in_its_range(void** state)
{
    (void)state;
    assert_int_equal(line_gains_count * sizeof(float), sizeof(line_gains_t));
    line_gains_t gains = line_gains_default();
    for (size_t i = 0; i < line_gains_count; i++)
    {
        const line_gain_definition_t* const one = &line_gain_definitions[i];
        assert_true(one->minimum <= one->default_value && one->default_value <= one->maximum && one->step > 0.0F);
        assert_true(line_gains_set(&gains, i, one->minimum));
        for (size_t other = i + 1; other < line_gains_count; other++)
        {
            assert_close(line_gains_get(&gains, other), line_gain_definitions[other].default_value, 0.0);
        }
    }
}

static void a_gain_is_set_by_its_place(void** state)
{
    (void)state;
    line_gains_t gains = line_gains_default();
    assert_true(line_gains_set(&gains, index_of("line_bank_limit"), 40.0F));
    assert_close(gains.follow.bank_limit_deg, 40.0, 0.0);
    assert_close(line_gains_get(&gains, index_of("line_bank_limit")), 40.0, 0.0);
}

static void a_value_outside_of_its_range_changes_nothing(void** state)
{
    (void)state;
    line_gains_t gains = line_gains_default();
    const line_gains_t before = gains;
    assert_false(line_gains_set(&gains, index_of("line_bank_limit"), 90.0F));
    assert_false(line_gains_set(&gains, index_of("line_bank_limit"), NAN));
    assert_false(line_gains_set(&gains, line_gains_count, 1.0F));
    assert_memory_equal(&gains, &before, sizeof gains);
    assert_close(line_gains_get(&gains, line_gains_count), 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_gain_has_its_own_place_and_a_default_in_its_range),
        cmocka_unit_test(a_gain_is_set_by_its_place),
        cmocka_unit_test(a_value_outside_of_its_range_changes_nothing),
    };
    return cmocka_run_group_tests_name("flight.line_gains", tests, NULL, NULL);
}
