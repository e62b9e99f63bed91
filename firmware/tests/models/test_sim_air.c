#include "support/cmocka_all.h"

#include <math.h>

#include "sim_air.h"

static const float dt_s = 0.02F;

/// The mean of many readings at one place.
static message_analog_t measured(const sim_truth_t* truth, float throttle)
{
    sim_air_t model;
    sim_air_init(&model, 1);
    message_analog_t sum = {0};
    enum
    {
        readings = 500
    };
    for (int i = 0; i < readings; i++)
    {
        message_analog_t seen;
        sim_air_read(&model, truth, throttle, dt_s, &seen);
        sum.baro_hpa += seen.baro_hpa / readings;
        sum.pitot_pa += seen.pitot_pa / readings;
        sum.temperature_degc += seen.temperature_degc / readings;
        sum.battery_v += seen.battery_v / readings;
    }
    return sum;
}

static void the_standard_atmosphere_is_measured(void** state)
{
    (void)state;
    // Table of the standard atmosphere: 1000 m and 3000 m.
    const sim_truth_t low = {.altitude_m = 1000.0F};
    const sim_truth_t high = {.altitude_m = 3000.0F};
    assert_close(measured(&low, 0.0F).baro_hpa, 898.75, 0.6);
    assert_close(measured(&high, 0.0F).baro_hpa, 701.09, 0.6);
    assert_close(measured(&low, 0.0F).temperature_degc - measured(&high, 0.0F).temperature_degc, 13.0, 0.5);
}

static void the_pitot_tube_measures_the_airspeed(void** state)
{
    (void)state;
    const sim_truth_t flying = {.airspeed_m_s = 30.0F};
    const message_analog_t seen = measured(&flying, 0.5F);
    assert_close(seen.pitot_pa, 551.25, 1.0);
}

static void throttle_costs_voltage_at_once_and_charge_over_time(void** state)
{
    (void)state;
    const sim_truth_t anywhere = {0};
    assert_true(measured(&anywhere, 0.0F).battery_v - measured(&anywhere, 1.0F).battery_v > 1.5F);
    sim_air_t model;
    sim_air_init(&model, 1);
    message_analog_t seen;
    float before_v = 100.0F;
    for (int minute = 0; minute < 20; minute++)
    {
        for (int i = 0; i < 300; i++)
        {
            sim_air_read(&model, &anywhere, 0.8F, 0.2F, &seen);
        }
        assert_true(seen.battery_v < before_v - 0.05F);
        before_v = seen.battery_v;
    }
}

static void an_empty_battery_stays_plausible(void** state)
{
    (void)state;
    const sim_truth_t anywhere = {0};
    sim_air_t model;
    sim_air_init(&model, 1);
    message_analog_t seen;
    for (int i = 0; i < 100000; i++)
    {
        sim_air_read(&model, &anywhere, 1.0F, 0.2F, &seen);
    }
    assert_close(seen.battery_v, 32.7, 0.3);
}

static void what_the_board_has_no_sensor_for_is_not_measured(void** state)
{
    (void)state;
    const sim_truth_t anywhere = {0};
    sim_air_t model;
    sim_air_init(&model, 1);
    message_analog_t seen;
    sim_air_read(&model, &anywhere, 0.0F, dt_s, &seen);
    assert_true(isnan(seen.alpha_deg));
    assert_true(isnan(seen.beta_deg));
    // these are for the board to work out
    assert_true(isnan(seen.altitude_m));
    assert_true(isnan(seen.calibrated_airspeed_kt));
    assert_true(isnan(seen.vvi_ft_min));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_standard_atmosphere_is_measured),
        cmocka_unit_test(the_pitot_tube_measures_the_airspeed),
        cmocka_unit_test(throttle_costs_voltage_at_once_and_charge_over_time),
        cmocka_unit_test(an_empty_battery_stays_plausible),
        cmocka_unit_test(what_the_board_has_no_sensor_for_is_not_measured),
    };
    return cmocka_run_group_tests_name("models.sim_air", tests, NULL, NULL);
}
