#include "support/cmocka_all.h"

#include <stdbool.h>
#include <string.h>

#include "common/angle.h"
#include "estimation/estimator.h"

static const float step_s = 0.02F;

/// Level at 1000 m of pressure altitude and 28.33 m/s, the nose at magnetic north.
static const estimator_samples_t cruise = {
    .accelerometer_m_s2 = {0.0F, 0.0F, -9.80665F},
    .magnetometer = {0.79F, 0.0F, 0.62F},
    .static_pa = 89874.5F,
    .pitot_pa = 492.2F,
    .is_measured = {true, true, true, true, true},
};

/// At Gando, where magnetic north is 3.1 deg west of true north.
static void start(estimator_t* estimator)
{
    estimator_init(estimator);
    estimator_locate(estimator, 27.9319F, -15.3866F);
}

static estimate_t run(estimator_t* estimator, const estimator_samples_t* samples, float seconds)
{
    estimate_t estimate = {0};
    const long steps = lroundf(seconds / step_s);
    for (long i = 0; i < steps; i++)
    {
        estimate = estimator_update(estimator, samples, step_s);
    }
    return estimate;
}

static void before_the_first_samples_nothing_is_known(void** state)
{
    (void)state;
    estimator_t estimator;
    estimator_init(&estimator);
    const estimator_samples_t nothing = {0};
    const estimate_t estimate = estimator_update(&estimator, &nothing, step_s);
    assert_true(isnan(estimate.attitude.yaw_deg) && isnan(estimate.attitude.pitch_deg));
    assert_true(isnan(estimate.attitude.roll_deg) && isnan(estimate.rate_rad_s[1]));
    assert_true(isnan(estimate.altitude_m) && isnan(estimate.vertical_speed_m_s));
    assert_true(isnan(estimate.calibrated_airspeed_m_s));
    for (int sensor = 0; sensor < estimator_sensor_count; sensor++)
    {
        assert_int_equal(estimator.refused[sensor], 0); // missing is not refused
    }
}

static void steady_cruise_is_what_the_sensors_say(void** state)
{
    (void)state;
    estimator_t estimator;
    start(&estimator);
    const estimate_t estimate = run(&estimator, &cruise, 10.0F);
    assert_close(estimate.attitude.yaw_deg, 356.9, 0.1);
    assert_close(estimate.attitude.pitch_deg, 0.0, 0.1);
    assert_close(estimate.attitude.roll_deg, 0.0, 0.1);
    assert_close(estimate.altitude_m, 1000.0, 1.0);
    assert_close(estimate.vertical_speed_m_s, 0.0, 0.01);
    assert_close(estimate.calibrated_airspeed_m_s, 28.33, 0.02);
    assert_close(estimate.rate_rad_s[0], 0.0, 0.001);
}

/// A turn of 0.2 rad/s at 29.74 m/s true (28.33 calibrated) has a bank of 31.24 degrees.
static void the_turn_is_corrected_with_the_true_airspeed(void** state)
{
    (void)state;
    estimator_t estimator;
    start(&estimator);
    estimator_samples_t turning = cruise;
    turning.is_measured[estimator_magnetometer] = false;
    const float bank_rad = 0.5452F;
    turning.gyro_rad_s[1] = 0.2F * sinf(bank_rad);
    turning.gyro_rad_s[2] = 0.2F * cosf(bank_rad);
    turning.accelerometer_m_s2[2] = -9.80665F / cosf(bank_rad);
    assert_close(run(&estimator, &turning, 60.0F).attitude.roll_deg, 31.24, 0.2);
}

static void a_sample_that_is_not_finite_is_refused_and_changes_nothing(void** state)
{
    (void)state;
    const float wrong[] = {NAN, INFINITY, -INFINITY, 1e9F, -1e9F};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
    {
        estimator_t estimator;
        start(&estimator);
        const estimate_t before = run(&estimator, &cruise, 5.0F);
        estimator_samples_t bad = cruise;
        bad.gyro_rad_s[1] = wrong[i];
        bad.accelerometer_m_s2[2] = wrong[i];
        bad.magnetometer[0] = wrong[i];
        bad.static_pa = wrong[i];
        bad.pitot_pa = wrong[i];
        const estimate_t during = run(&estimator, &bad, 0.06F);
        for (int sensor = 0; sensor < estimator_sensor_count; sensor++)
        {
            assert_int_equal(estimator.refused[sensor], 3);
        }
        assert_close(during.attitude.roll_deg, before.attitude.roll_deg, 0.05);
        assert_close(during.attitude.yaw_deg, before.attitude.yaw_deg, 0.05);
        assert_close(during.altitude_m, before.altitude_m, 0.1);
        assert_close(during.calibrated_airspeed_m_s, before.calibrated_airspeed_m_s, 0.001);
    }
}

static void each_sensor_is_judged_by_itself(void** state)
{
    (void)state;
    estimator_t estimator;
    start(&estimator);
    (void)run(&estimator, &cruise, 5.0F);
    estimator_samples_t bad = cruise;
    bad.pitot_pa = NAN;
    const estimate_t estimate = run(&estimator, &bad, 2.0F);
    assert_int_equal(estimator.refused[estimator_pitot], 100);
    assert_int_equal(estimator.refused[estimator_static_pressure], 0);
    assert_true(isnan(estimate.calibrated_airspeed_m_s));
    assert_close(estimate.altitude_m, 1000.0, 1.0);
    assert_close(estimate.attitude.pitch_deg, 0.0, 0.1);
}

static void a_gyro_that_falls_silent_has_no_rates_but_the_horizon_stands(void** state)
{
    (void)state;
    estimator_t estimator;
    start(&estimator);
    (void)run(&estimator, &cruise, 5.0F);
    estimator_samples_t silent = cruise;
    silent.is_measured[estimator_gyro] = false;
    const estimate_t during = run(&estimator, &silent, 10.0F);
    assert_true(isnan(during.rate_rad_s[0]));
    assert_close(during.attitude.pitch_deg, 0.0, 0.2);
    assert_close(run(&estimator, &cruise, 1.0F).rate_rad_s[0], 0.0, 0.001);
}

static void the_heading_is_true_wherever_the_aircraft_is(void** state)
{
    (void)state;
    // what the nose at magnetic north shows: the declination of Gando, of Christchurch, and of Gando again
    const float places_deg[][3] = {
        {27.9319F, -15.3866F, 356.9F}, {-43.53F, 172.63F, 24.8F}, {27.9319F, -15.3866F, 356.9F}};
    estimator_t estimator;
    estimator_init(&estimator);
    for (size_t i = 0; i < sizeof places_deg / sizeof places_deg[0]; i++)
    {
        estimator_locate(&estimator, places_deg[i][0], places_deg[i][1]);
        const estimate_t estimate = run(&estimator, &cruise, i == 0 ? 10.0F : step_s);
        assert_close(estimate.attitude.yaw_deg, places_deg[i][2], 0.1);
        assert_close(estimate.rate_rad_s[2], 0.0, 0.001); // the aircraft has not turned
    }
}

static void without_a_place_the_horizon_is_known_and_the_heading_is_not(void** state)
{
    (void)state;
    estimator_t estimator;
    estimator_init(&estimator);
    const float wrong[][2] = {{NAN, -15.0F}, {28.0F, NAN}, {90.5F, 0.0F}, {0.0F, -180.5F}, {INFINITY, 0.0F}};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
    {
        estimator_locate(&estimator, wrong[i][0], wrong[i][1]);
        const estimate_t estimate = run(&estimator, &cruise, 1.0F);
        assert_true(isnan(estimate.attitude.yaw_deg));
        assert_close(estimate.attitude.pitch_deg, 0.0, 0.5);
    }
    estimator_locate(&estimator, 27.9319F, -15.3866F);
    estimator_locate(&estimator, NAN, NAN); // the GPS lost it: the last place stands
    assert_close(run(&estimator, &cruise, step_s).attitude.yaw_deg, 356.9, 0.1);
}

static void the_same_samples_give_the_same_estimate(void** state)
{
    (void)state;
    estimator_t first;
    estimator_t second;
    start(&first);
    start(&second);
    const estimate_t a = run(&first, &cruise, 3.0F);
    const estimate_t b = run(&second, &cruise, 3.0F);
    assert_memory_equal(&a, &b, sizeof a); // no state beside the caller's
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(before_the_first_samples_nothing_is_known),
        cmocka_unit_test(steady_cruise_is_what_the_sensors_say),
        cmocka_unit_test(the_turn_is_corrected_with_the_true_airspeed),
        cmocka_unit_test(a_sample_that_is_not_finite_is_refused_and_changes_nothing),
        cmocka_unit_test(each_sensor_is_judged_by_itself),
        cmocka_unit_test(a_gyro_that_falls_silent_has_no_rates_but_the_horizon_stands),
        cmocka_unit_test(the_heading_is_true_wherever_the_aircraft_is),
        cmocka_unit_test(without_a_place_the_horizon_is_known_and_the_heading_is_not),
        cmocka_unit_test(the_same_samples_give_the_same_estimate),
    };
    return cmocka_run_group_tests_name("estimation.estimator", tests, NULL, NULL);
}
