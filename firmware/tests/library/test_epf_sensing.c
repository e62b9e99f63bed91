#include "support/cmocka_all.h"

#include <string.h>

#include "epf_sensing.h"

static epf_sensing_readings_t after(float seconds, uint32_t is_gyro_silent)
{
    static const float step_s = 0.01F;
    epf_sensing_readings_t readings;
    const long steps = lroundf(seconds / step_s);
    for (long i = 0; i < steps; i++)
    {
        epf_sensing_step(step_s, is_gyro_silent, &readings);
    }
    return readings;
}

static void a_board_without_a_simulator_stands_on_the_runway(void** state)
{
    (void)state;
    epf_sensing_start(1);
    // Right after the start, too.
    assert_close(after(0.2F, 0U).ahrs.pitch_deg, 0.0, 1.0);
    const epf_sensing_readings_t readings = after(5.0F, 0U);
    assert_close(readings.ahrs.yaw_deg, 28.0, 2.0);
    assert_close(readings.ahrs.pitch_deg, 0.0, 1.0);
    assert_close(readings.analog.altitude_m, 23.8, 5.0);
}

static void it_follows_what_the_simulator_tells(void** state)
{
    (void)state;
    epf_sensing_start(1);
    uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
    const command_xplane_info_t info = {
        .yaw_deg = 90.0F, .altitude_ft = 1000.0F, .speed_kt = 55.0F, .latitude_deg = 27.9F, .longitude_deg = -15.4F};
    command_xplane_info_pack(&info, payload);
    epf_sensing_readings_t readings;
    for (int i = 0; i < 1000; i++)
    {
        epf_sensing_observe(payload, 0.5F);
        epf_sensing_step(0.01F, 0U, &readings);
    }
    assert_close(readings.ahrs.yaw_deg, 90.0, 2.0);
    assert_close(readings.analog.altitude_m, 304.8, 5.0);
    assert_close(readings.analog.calibrated_airspeed_kt, 55.0, 2.0);
}

static void a_silent_gyro_measures_no_rates(void** state)
{
    (void)state;
    epf_sensing_start(1);
    assert_true(isfinite(after(1.0F, 0U).inertial.gx_rad_s));
    assert_true(isnan(after(1.0F, 1U).inertial.gx_rad_s));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_board_without_a_simulator_stands_on_the_runway),
        cmocka_unit_test(it_follows_what_the_simulator_tells),
        cmocka_unit_test(a_silent_gyro_measures_no_rates),
    };
    return cmocka_run_group_tests_name("library.epf_sensing", tests, NULL, NULL);
}
