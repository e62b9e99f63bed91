#include "support/cmocka_all.h"

#include "flight/failsafe.h"

static const float step_s = 0.02F;

static void a_cause_acts_once_it_has_lasted_and_not_before(void** state)
{
    (void)state;
    for (size_t i = 0; i < failsafe_count; i++)
    {
        const failsafe_cause_t cause = (failsafe_cause_t)i;
        failsafe_t failsafe = {0};
        assert_false(failsafe_is_active(&failsafe, cause));
        for (uint32_t lasted_ms = 20; lasted_ms <= 1000; lasted_ms += 20)
        {
            failsafe_note(&failsafe, cause, true, step_s);
            assert_int_equal(failsafe_is_active(&failsafe, cause), lasted_ms >= failsafe_table[i].after_ms);
        }
    }
}

static void a_cause_that_goes_is_forgotten_at_once(void** state)
{
    (void)state;
    failsafe_t failsafe = {0};
    failsafe_note(&failsafe, failsafe_receiver_silent, true, 10.0F);
    assert_true(failsafe_is_active(&failsafe, failsafe_receiver_silent));
    failsafe_note(&failsafe, failsafe_receiver_silent, false, step_s);
    assert_false(failsafe_is_active(&failsafe, failsafe_receiver_silent));
    failsafe_note(&failsafe, failsafe_receiver_silent, true, step_s);
    assert_false(failsafe_is_active(&failsafe, failsafe_receiver_silent));
}

static void causes_do_not_mix(void** state)
{
    (void)state;
    failsafe_t failsafe = {0};
    failsafe_note(&failsafe, failsafe_rates_unknown, true, 10.0F);
    for (size_t i = 0; i < failsafe_count; i++)
    {
        assert_int_equal(failsafe_is_active(&failsafe, (failsafe_cause_t)i), i == failsafe_rates_unknown);
    }
}

static void without_a_cause_it_flies_on_and_with_one_by_the_table(void** state)
{
    (void)state;
    for (size_t i = 0; i < failsafe_count; i++)
    {
        const failsafe_cause_t cause = (failsafe_cause_t)i;
        failsafe_t failsafe = {0};
        assert_int_equal(failsafe_action(&failsafe, cause, true), failsafe_flies_on);
        assert_int_equal(failsafe_action(&failsafe, cause, false), failsafe_flies_on);
        failsafe_note(&failsafe, cause, true, 10.0F);
        assert_int_equal(failsafe_action(&failsafe, cause, true), failsafe_table[i].autopilot);
        assert_int_equal(failsafe_action(&failsafe, cause, false), failsafe_table[i].pilot);
    }
}

static void every_cause_changes_something_or_is_flown_on_through(void** state)
{
    (void)state;
    // The autopilot needs neither the station nor the transmitter; a pilot needs neither attitude nor altitude.
    assert_int_equal(failsafe_table[failsafe_simulator_silent].autopilot, failsafe_flies_on);
    assert_int_equal(failsafe_table[failsafe_receiver_silent].autopilot, failsafe_flies_on);
    assert_int_equal(failsafe_table[failsafe_simulator_silent].after_ms, 500);
    assert_int_equal(failsafe_table[failsafe_receiver_silent].after_ms, 500);
    for (size_t i = 0; i < failsafe_count; i++)
    {
        assert_non_null(failsafe_table[i].name);
        assert_true(failsafe_table[i].autopilot != failsafe_flies_on || failsafe_table[i].pilot != failsafe_flies_on);
    }
    assert_true(failsafe_surfaces.throttle >= 0.0F && failsafe_surfaces.throttle <= 1.0F);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cause_acts_once_it_has_lasted_and_not_before),
        cmocka_unit_test(a_cause_that_goes_is_forgotten_at_once),
        cmocka_unit_test(causes_do_not_mix),
        cmocka_unit_test(without_a_cause_it_flies_on_and_with_one_by_the_table),
        cmocka_unit_test(every_cause_changes_something_or_is_flown_on_through),
    };
    return cmocka_run_group_tests_name("flight.failsafe", tests, NULL, NULL);
}
