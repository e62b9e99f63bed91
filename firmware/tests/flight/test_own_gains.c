#include "support/cmocka_all.h"

#include <math.h>

#include "flight/own_gains.h"

static void every_gain_begins_with_its_default_and_takes_its_range(void** state)
{
    (void)state;
    assert_int_equal(own_gains_count(), 1 + line_gains_count);
    for (size_t i = 0; i < own_gains_count(); i++)
    {
        tuning_t tuning;
        tuning_init(&tuning);
        own_gain_t gain;
        assert_true(own_gains_describe(i, &gain));
        assert_close(own_gains_get(&tuning, i), gain.default_value, 0.0);
        assert_true(own_gains_set(&tuning, i, gain.maximum));
        assert_close(own_gains_get(&tuning, i), gain.maximum, 0.0);
        assert_true(own_gains_set(&tuning, i, gain.minimum));
        assert_close(own_gains_get(&tuning, i), gain.minimum, 0.0);
        assert_false(own_gains_set(&tuning, i, gain.minimum - 0.5F));
        assert_false(own_gains_set(&tuning, i, gain.maximum + 0.5F));
        assert_false(own_gains_set(&tuning, i, NAN));
        assert_close(own_gains_get(&tuning, i), gain.minimum, 0.0);
    }
}

static void the_first_chooses_the_law_by_a_whole_number(void** state)
{
    (void)state;
    tuning_t tuning;
    tuning_init(&tuning);
    assert_false(own_gains_set(&tuning, 0, 0.5F));
    assert_int_equal(tuning.gains.law, guidance_law_bearing);
    assert_true(own_gains_set(&tuning, 0, 1.0F));
    assert_int_equal(tuning.gains.law, guidance_law_line);
}

static void the_others_are_the_line_law_s_in_their_order(void** state)
{
    (void)state;
    tuning_t tuning;
    tuning_init(&tuning);
    own_gain_t gain;
    assert_true(own_gains_describe(1, &gain));
    assert_string_equal(gain.name, "line_bank_limit");
    assert_true(own_gains_set(&tuning, 1, 41.0F));
    assert_close(tuning.gains.line.follow.bank_limit_deg, 41.0, 0.0);
}

static void all_of_them_are_copied_and_the_parameters_stay(void** state)
{
    (void)state;
    tuning_t tuning;
    tuning_t other;
    tuning_init(&tuning);
    tuning_init(&other);
    assert_true(tuning_set(&other, 0, parameter_definitions[0].maximum));
    own_gain_t gain;
    for (size_t i = 0; own_gains_describe(i, &gain); i++)
    {
        assert_true(own_gains_set(&other, i, gain.maximum));
    }
    own_gains_copy(&tuning, &other);
    for (size_t i = 0; own_gains_describe(i, &gain); i++)
    {
        assert_close(own_gains_get(&tuning, i), gain.maximum, 0.0);
    }
    assert_close(tuning.parameters.values[0], parameter_definitions[0].default_value, 0.0);
}

static void a_number_without_a_gain_is_refused(void** state)
{
    (void)state;
    tuning_t tuning;
    tuning_init(&tuning);
    own_gain_t gain;
    assert_false(own_gains_describe(own_gains_count(), &gain));
    assert_false(own_gains_set(&tuning, own_gains_count(), 1.0F));
    assert_close(own_gains_get(&tuning, own_gains_count()), 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_gain_begins_with_its_default_and_takes_its_range),
        cmocka_unit_test(the_first_chooses_the_law_by_a_whole_number),
        cmocka_unit_test(the_others_are_the_line_law_s_in_their_order),
        cmocka_unit_test(all_of_them_are_copied_and_the_parameters_stay),
        cmocka_unit_test(a_number_without_a_gain_is_refused),
    };
    return cmocka_run_group_tests_name("flight.own_gains", tests, NULL, NULL);
}
