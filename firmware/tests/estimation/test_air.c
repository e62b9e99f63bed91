#include "support/cmocka_all.h"

#include "estimation/air.h"

// ICAO doc 7488: pressure of the standard atmosphere by height.
static void altitudes_are_those_of_the_standard_atmospheres_table(void** state)
{
    (void)state;
    assert_close(air_altitude_m(101325.0F), 0.0, 0.1);
    assert_close(air_altitude_m(95461.0F), 500.0, 1.0);
    assert_close(air_altitude_m(89874.5F), 1000.0, 1.0);
    assert_close(air_altitude_m(54019.9F), 5000.0, 3.0);
    assert_close(air_altitude_m(102532.0F), -100.0, 1.0);
}

// q = p0 ((1 + 0.2 (V / a0)^2)^3.5 - 1), worked out by hand.
static void airspeeds_are_those_of_the_compressible_law(void** state)
{
    (void)state;
    assert_close(air_calibrated_speed_m_s(0.0F), 0.0, 0.0);
    assert_close(air_calibrated_speed_m_s(61.26F), 10.0, 0.01);
    assert_close(air_calibrated_speed_m_s(492.2F), 28.33, 0.02);
    assert_close(air_calibrated_speed_m_s(6258.0F), 100.0, 0.05);
}

static void a_slightly_negative_pressure_at_rest_gives_a_slightly_negative_airspeed(void** state)
{
    (void)state;
    assert_close(air_calibrated_speed_m_s(-0.6125F), -1.0, 0.01);
}

// rho / rho0 is 0.9075 at 1000 m and 0.6012 at 5000 m.
static void the_air_is_faster_than_it_feels_up_high(void** state)
{
    (void)state;
    assert_close(air_true_speed_m_s(30.0F, 101325.0F), 30.0, 0.001);
    assert_close(air_true_speed_m_s(30.0F, 89874.5F), 31.49, 0.02);
    assert_close(air_true_speed_m_s(30.0F, 54019.9F), 38.69, 0.03);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(altitudes_are_those_of_the_standard_atmospheres_table),
        cmocka_unit_test(airspeeds_are_those_of_the_compressible_law),
        cmocka_unit_test(a_slightly_negative_pressure_at_rest_gives_a_slightly_negative_airspeed),
        cmocka_unit_test(the_air_is_faster_than_it_feels_up_high),
    };
    return cmocka_run_group_tests_name("estimation.air", tests, NULL, NULL);
}
