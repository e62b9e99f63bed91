#include "support/cmocka_all.h"

#include "flight/gains.h"
#include "flight/tuning.h"
#include "params/parameters_gen.h"

static void assert_gains_follow(const tuning_t* tuning)
{
    const control_loop_gains_t gains = gains_of(&tuning->parameters);
    assert_memory_equal(&tuning->gains, &gains, sizeof gains);
}

static void it_begins_with_the_defaults(void** state)
{
    (void)state;
    tuning_t tuning;
    tuning_init(&tuning);
    assert_close(tuning.parameters.values[PARAMETER_K_ROLL], 2.0, 0.0);
    assert_gains_follow(&tuning);
}

static void setting_a_parameter_changes_its_gain(void** state)
{
    (void)state;
    tuning_t tuning;
    tuning_init(&tuning);
    assert_true(tuning_set(&tuning, PARAMETER_K_ROLL, 3.5F));
    assert_close(tuning.gains.autopilot.k_roll, 3.5, 0.0);
    assert_gains_follow(&tuning);
}

static void a_value_outside_of_its_range_changes_nothing(void** state)
{
    (void)state;
    tuning_t tuning;
    tuning_init(&tuning);
    const tuning_t before = tuning;
    assert_false(tuning_set(&tuning, PARAMETER_K_ROLL, -1000.0F));
    assert_false(tuning_set(&tuning, PARAMETER_K_ROLL, NAN));
    assert_memory_equal(&tuning, &before, sizeof tuning);
}

static void replacing_the_set_changes_all_gains(void** state)
{
    (void)state;
    tuning_t tuning;
    tuning_init(&tuning);
    parameters_t others;
    for (size_t i = 0; i < parameters_count; i++)
    {
        others.values[i] = parameter_definitions[i].maximum;
    }
    tuning_replace(&tuning, &others);
    assert_memory_equal(&tuning.parameters, &others, sizeof others);
    assert_gains_follow(&tuning);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_begins_with_the_defaults),
        cmocka_unit_test(setting_a_parameter_changes_its_gain),
        cmocka_unit_test(a_value_outside_of_its_range_changes_nothing),
        cmocka_unit_test(replacing_the_set_changes_all_gains),
    };
    return cmocka_run_group_tests_name("flight.tuning", tests, NULL, NULL);
}
