#include "support/cmocka_all.h"

#include "epf_estimation.h"

static const estimator_samples_t level = {
    .accelerometer_m_s2 = {0.0F, 0.0F, -9.80665F},
    .magnetometer = {0.79F, 0.0F, 0.62F},
    .static_pa = 101325.0F,
    .is_measured = {true, true, true, true, true},
};

static void steps_from_another_language_give_the_estimators_own_estimate(void** state)
{
    (void)state;
    estimator_t* const estimator = epf_estimation_new();
    assert_non_null(estimator);
    epf_estimation_locate(estimator, 27.9319F, -15.3866F);
    estimate_t estimate;
    for (int i = 0; i < 100; i++)
    {
        epf_estimation_step(estimator, &level, 0.02F, &estimate);
    }
    assert_close(estimate.attitude.yaw_deg, 356.9, 0.1);
    assert_close(estimate.altitude_m, 0.0, 0.1);
    epf_estimation_free(estimator);
}

static void refused_samples_are_counted_for_each_sensor(void** state)
{
    (void)state;
    estimator_t* const estimator = epf_estimation_new();
    estimator_samples_t bad = level;
    bad.magnetometer[1] = NAN;
    estimate_t estimate;
    epf_estimation_step(estimator, &bad, 0.02F, &estimate);
    assert_int_equal(epf_estimation_refused(estimator, estimator_magnetometer), 1);
    assert_int_equal(epf_estimation_refused(estimator, estimator_gyro), 0);
    assert_int_equal(epf_estimation_refused(estimator, estimator_sensor_count), 0);
    epf_estimation_free(estimator);
}

static void the_field_of_a_place_is_north_east_and_down(void** state)
{
    (void)state;
    vector_t field_nt;
    epf_magnetic_field(27.9319F, -15.3866F, &field_nt);
    assert_true(field_nt.x > 30000.0F && field_nt.z > 20000.0F);
    assert_true(field_nt.y < -1000.0F && field_nt.y > -3000.0F);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_from_another_language_give_the_estimators_own_estimate),
        cmocka_unit_test(the_field_of_a_place_is_north_east_and_down),
        cmocka_unit_test(refused_samples_are_counted_for_each_sensor),
    };
    return cmocka_run_group_tests_name("library.epf_estimation", tests, NULL, NULL);
}
