#include "support/cmocka_all.h"

#include "app/sensing.h"

static const float step_s = 0.01F;

/// Level at 1000 m of pressure altitude and 28.33 m/s, the nose at magnetic north; GPS and receiver as they come.
static sensors_reading_t cruise(void)
{
    sensors_reading_t reading = {
        .inertial = {.accz_m_s2 = -9.80665F, .magx = 0.79F, .magz = 0.62F},
        .analog = {.baro_hpa = 898.745F,
                   .altitude_m = NAN,
                   .pitot_pa = 492.2F,
                   .calibrated_airspeed_kt = NAN,
                   .battery_v = 40.0F,
                   .vvi_ft_min = NAN},
        .gps = {.latitude_deg = 27.9319F, .longitude_deg = -15.3866F, .valid = 'A'},
    };
    reading.receiver.channel[3] = 0.25F;
    return reading;
}

static void sense(estimator_t* estimator, const sensors_reading_t* reading, float seconds, board_sensors_t* sensors)
{
    const long steps = lroundf(seconds / step_s);
    for (long i = 0; i < steps; i++)
    {
        sensing_update(estimator, reading, step_s, sensors);
    }
}

static void the_board_says_what_it_estimates(void** state)
{
    (void)state;
    estimator_t estimator;
    estimator_init(&estimator);
    board_sensors_t sensors = {.statistics = {.control_dsc_percent = 7}};
    const sensors_reading_t reading = cruise();
    sense(&estimator, &reading, 5.0F, &sensors);
    assert_close(sensors.ahrs.yaw_deg, 356.9, 0.2); // true: the field is 3.1 degrees west of it
    assert_close(sensors.ahrs.pitch_deg, 0.0, 0.2);
    assert_close(sensors.ahrs.roll_deg, 0.0, 0.2);
    assert_close(sensors.analog.altitude_m, 1000.0, 1.0);
    assert_close(sensors.analog.calibrated_airspeed_kt, 55.07, 0.1);
    assert_close(sensors.analog.vvi_ft_min, 0.0, 5.0);
}

static void what_is_not_estimated_comes_through_as_it_was_measured(void** state)
{
    (void)state;
    estimator_t estimator;
    estimator_init(&estimator);
    board_sensors_t sensors = {.statistics = {.control_dsc_percent = 7}};
    const sensors_reading_t reading = cruise();
    sense(&estimator, &reading, 0.1F, &sensors);
    assert_close(sensors.inertial.accz_m_s2, -9.80665, 1e-6);
    assert_close(sensors.inertial.magx, 0.79, 1e-6);
    assert_close(sensors.analog.battery_v, 40.0, 1e-6);
    assert_close(sensors.gps.latitude_deg, 27.9319, 1e-5);
    assert_close(sensors.servos_in.channel[3], 0.25, 1e-6);
    assert_int_equal(sensors.statistics.control_dsc_percent, 7); // not the sensors' to say
}

static void the_heading_is_not_known_before_the_gps_knows_where_the_board_is(void** state)
{
    (void)state;
    estimator_t estimator;
    estimator_init(&estimator);
    board_sensors_t sensors = {0};
    sensors_reading_t reading = cruise();
    reading.gps.valid = 'V';
    sense(&estimator, &reading, 5.0F, &sensors);
    assert_true(isnan(sensors.ahrs.yaw_deg));
    assert_close(sensors.ahrs.roll_deg, 0.0, 0.2);
    reading.gps.valid = 'A';
    sense(&estimator, &reading, step_s, &sensors);
    assert_close(sensors.ahrs.yaw_deg, 356.9, 0.2);
}

static void rates_come_without_the_gyros_bias(void** state)
{
    (void)state;
    estimator_t estimator;
    estimator_init(&estimator);
    board_sensors_t sensors = {0};
    sensors_reading_t reading = cruise();
    reading.inertial.gy_rad_s = 0.01F;
    sense(&estimator, &reading, 120.0F, &sensors);
    assert_close(sensors.inertial.gy_rad_s, 0.0, 0.002);
}

static void a_sensor_that_does_not_measure_is_missing_and_not_refused(void** state)
{
    (void)state;
    estimator_t estimator;
    estimator_init(&estimator);
    board_sensors_t sensors = {0};
    sensors_reading_t reading = cruise();
    sense(&estimator, &reading, 5.0F, &sensors);
    reading.inertial.gx_rad_s = NAN;
    reading.analog.pitot_pa = NAN;
    sense(&estimator, &reading, 2.0F, &sensors);
    assert_true(isnan(sensors.inertial.gx_rad_s));
    assert_true(isnan(sensors.analog.calibrated_airspeed_kt));
    assert_close(sensors.ahrs.roll_deg, 0.0, 0.5); // gravity and compass hold it
    assert_int_equal(estimator.refused[estimator_gyro], 0);
    assert_int_equal(estimator.refused[estimator_pitot], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_board_says_what_it_estimates),
        cmocka_unit_test(what_is_not_estimated_comes_through_as_it_was_measured),
        cmocka_unit_test(the_heading_is_not_known_before_the_gps_knows_where_the_board_is),
        cmocka_unit_test(rates_come_without_the_gyros_bias),
        cmocka_unit_test(a_sensor_that_does_not_measure_is_missing_and_not_refused),
    };
    return cmocka_run_group_tests_name("app.sensing", tests, NULL, NULL);
}
