#include "support/cmocka_all.h"

#include <stdbool.h>

#include "estimation/vertical.h"
#include "support/random.h"

static const float step_s = 0.02F;

/// Fly for `seconds` with the barometer at `altitude_m` and this acceleration.
static void hold(vertical_filter_t* filter, float altitude_m, float acceleration_m_s2, float seconds)
{
    const vertical_input_t input = {altitude_m, true, acceleration_m_s2, true};
    for (float t = 0.0F; t < seconds; t += step_s)
    {
        vertical_update(filter, &input, step_s);
    }
}

static void the_first_altitude_is_taken_at_once(void** state)
{
    (void)state;
    vertical_filter_t filter;
    vertical_init(&filter);
    assert_false(vertical_is_known(&filter));
    hold(&filter, 700.0F, 0.0F, step_s / 2.0F);
    assert_true(vertical_is_known(&filter));
    assert_close(filter.altitude_m, 700.0, 0.001);
    assert_close(filter.speed_m_s, 0.0, 0.001);
}

static void in_level_flight_an_accelerometers_bias_gives_no_climb(void** state)
{
    (void)state;
    vertical_filter_t filter;
    vertical_init(&filter);
    hold(&filter, 300.0F, 0.3F, 60.0F);
    assert_close(filter.speed_m_s, 0.0, 0.01);
    assert_close(filter.altitude_m, 300.0, 0.05);
}

static void a_steady_climb_is_measured_without_lag(void** state)
{
    (void)state;
    vertical_filter_t filter;
    vertical_init(&filter);
    float altitude_m = 100.0F;
    for (int i = 0; i < 1500; i++)
    {
        altitude_m += 3.0F * step_s;
        const vertical_input_t input = {altitude_m, true, 0.0F, true};
        vertical_update(&filter, &input, step_s);
    }
    assert_close(filter.speed_m_s, 3.0, 0.02);
    assert_close(filter.altitude_m, altitude_m, 0.1);
}

static void a_pull_up_shows_before_the_barometer_has_moved(void** state)
{
    (void)state;
    vertical_filter_t filter;
    vertical_init(&filter);
    hold(&filter, 300.0F, 0.0F, 10.0F);
    hold(&filter, 300.0F, 5.0F, 0.2F);
    assert_true(filter.speed_m_s > 0.8F);
}

static void the_barometers_noise_is_smoothed(void** state)
{
    (void)state;
    vertical_filter_t filter;
    vertical_init(&filter);
    uint32_t random = 5;
    float worst_m_s = 0.0F;
    for (int i = 0; i < 3000; i++)
    {
        const float noise_m = (float)(random_next(&random) % 2001U) / 1000.0F - 1.0F;
        const vertical_input_t input = {300.0F + noise_m, true, 0.0F, true};
        vertical_update(&filter, &input, step_s);
        worst_m_s = i > 500 ? fmaxf(worst_m_s, fabsf(filter.speed_m_s)) : 0.0F;
    }
    assert_true(worst_m_s < 0.4F);
}

static void without_a_barometer_it_goes_on_for_two_seconds_and_then_does_not_know(void** state)
{
    (void)state;
    vertical_filter_t filter;
    vertical_init(&filter);
    hold(&filter, 300.0F, 0.0F, 5.0F);
    const vertical_input_t silent = {.altitude_m = NAN, .acceleration_m_s2 = 1.0F, .has_acceleration = true};
    for (int i = 0; i < 50; i++)
    {
        vertical_update(&filter, &silent, step_s);
    }
    assert_true(vertical_is_known(&filter));
    assert_close(filter.speed_m_s, 1.0, 0.01);
    assert_close(filter.altitude_m, 300.5, 0.02);
    for (int i = 0; i < 60; i++)
    {
        vertical_update(&filter, &silent, step_s);
    }
    assert_false(vertical_is_known(&filter));
    hold(&filter, 420.0F, 0.0F, step_s / 2.0F);
    assert_true(vertical_is_known(&filter));
    assert_close(filter.altitude_m, 420.0, 0.001);
}

static void one_wild_altitude_does_not_throw_it_away_but_a_new_place_is_taken(void** state)
{
    (void)state;
    vertical_filter_t filter;
    vertical_init(&filter);
    hold(&filter, 300.0F, 0.0F, 10.0F);
    hold(&filter, 2000.0F, 0.0F, step_s / 2.0F);
    assert_close(filter.altitude_m, 300.0, 0.1);
    hold(&filter, 300.0F, 0.0F, 1.0F);
    hold(&filter, 1500.0F, 0.0F, 1.0F);
    assert_close(filter.altitude_m, 1500.0, 0.5);
    assert_close(filter.speed_m_s, 0.0, 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_altitude_is_taken_at_once),
        cmocka_unit_test(in_level_flight_an_accelerometers_bias_gives_no_climb),
        cmocka_unit_test(a_steady_climb_is_measured_without_lag),
        cmocka_unit_test(a_pull_up_shows_before_the_barometer_has_moved),
        cmocka_unit_test(the_barometers_noise_is_smoothed),
        cmocka_unit_test(without_a_barometer_it_goes_on_for_two_seconds_and_then_does_not_know),
        cmocka_unit_test(one_wild_altitude_does_not_throw_it_away_but_a_new_place_is_taken),
    };
    return cmocka_run_group_tests_name("estimation.vertical", tests, NULL, NULL);
}
