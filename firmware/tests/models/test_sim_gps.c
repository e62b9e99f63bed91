#include "support/cmocka_all.h"

#include "common/angle.h"
#include "navigation/geodesy.h"
#include "sim_gps.h"

static const float dt_s = 0.02F;
static const sim_truth_t gando = {
    .latitude_deg = 27.9319, .longitude_deg = -15.3866, .altitude_m = 23.8F, .yaw_deg = 28.0F, .track_deg = 28.0F};

/// Fly for `seconds` at a ground speed of `north` and `east` m/s and return the last solution.
static message_gps_t fly(sim_gps_t* model, sim_truth_t* truth, float seconds, float north_m_s, float east_m_s)
{
    message_gps_t seen = {0};
    const int steps = (int)(seconds / dt_s);
    truth->ground_speed_m_s = hypotf(north_m_s, east_m_s);
    truth->track_deg = angle_wrap_360(angle_to_deg(atan2f(east_m_s, north_m_s)));
    for (int i = 0; i < steps; i++)
    {
        truth->latitude_deg += (double)(north_m_s * dt_s) / GEODESY_M_PER_DEG;
        truth->longitude_deg += (double)(east_m_s * dt_s) / (GEODESY_M_PER_DEG * 0.8835);
        seen = sim_gps_read(model, truth, dt_s);
    }
    return seen;
}

static void a_standing_receiver_stays_within_metres(void** state)
{
    (void)state;
    sim_gps_t model;
    sim_gps_init(&model, 1);
    for (int i = 0; i < 5000; i++)
    {
        const message_gps_t seen = sim_gps_read(&model, &gando, dt_s);
        assert_close(seen.latitude_deg, 27.9319, 6.0 / GEODESY_M_PER_DEG);
        assert_close(seen.longitude_deg, -15.3866, 7.0 / 98000.0);
        assert_close(seen.altitude_m, 23.8, 12.0);
        assert_true(seen.speed_kt >= 0.0F && seen.speed_kt < 1.0F);
        assert_close(seen.heading_deg, 28.0, 0.0);
        assert_int_equal(seen.fix, '1');
        assert_int_equal(seen.valid, 'A');
    }
}

static void a_solution_comes_every_fifth_of_a_second(void** state)
{
    (void)state;
    sim_gps_t model;
    sim_gps_init(&model, 1);
    int changes = 0;
    message_gps_t before = sim_gps_read(&model, &gando, dt_s);
    for (int i = 0; i < 500; i++)
    {
        const message_gps_t seen = sim_gps_read(&model, &gando, dt_s);
        changes += seen.altitude_m < before.altitude_m || seen.altitude_m > before.altitude_m ? 1 : 0;
        before = seen;
    }
    assert_in_range(changes, 48, 50);
}

static void speed_and_track_are_those_over_the_ground(void** state)
{
    (void)state;
    sim_gps_t model;
    sim_gps_init(&model, 1);
    sim_truth_t truth = gando;
    const message_gps_t seen = fly(&model, &truth, 5.0F, -20.0F, 20.0F);
    assert_close(seen.speed_kt, 28.284 * 1.943844, 1.0);
    assert_close(seen.heading_deg, 135.0, 0.1);
}

static void speed_and_track_do_not_depend_on_the_time_between_readings(void** state)
{
    (void)state;
    sim_truth_t truth = gando;
    truth.ground_speed_m_s = 30.0F;
    static const float steps_s[] = {0.001F, 0.02F, 0.5F};
    for (size_t i = 0; i < sizeof steps_s / sizeof steps_s[0]; i++)
    {
        sim_gps_t model;
        sim_gps_init(&model, 1);
        for (int reading = 0; reading < 1000; reading++)
        {
            // as far in each step as the aircraft flies in 0.1 s
            truth.latitude_deg += 3.0 / GEODESY_M_PER_DEG;
            assert_close(sim_gps_read(&model, &truth, steps_s[i]).speed_kt, 58.3, 1.0);
        }
    }
}

static void it_tells_where_the_aircraft_was_a_solution_ago(void** state)
{
    (void)state;
    sim_gps_t model;
    sim_gps_init(&model, 1);
    sim_truth_t truth = gando;
    const message_gps_t seen = fly(&model, &truth, 20.0F, 100.0F, 0.0F);
    const double behind_m = (truth.latitude_deg - (double)seen.latitude_deg) * GEODESY_M_PER_DEG;
    assert_true(behind_m > 14.0 && behind_m < 46.0); // 0.2 to 0.4 s at 100 m/s, and the error
}

static void the_number_of_satellites_is_one_or_two_digits(void** state)
{
    (void)state;
    sim_gps_t model;
    sim_gps_init(&model, 3);
    int with_two = 0;
    int with_one = 0;
    for (int i = 0; i < 100000; i++)
    {
        const int32_t satellites = sim_gps_read(&model, &gando, dt_s).satellites;
        const int32_t units = satellites & 0xFF;
        const int32_t tens = satellites >> 8;
        assert_in_range(units, '0', '9');
        assert_true(tens == 0 || tens == '1');
        with_two += tens == '1' ? 1 : 0;
        with_one += tens == 0 ? 1 : 0;
    }
    assert_true(with_two > 0 && with_one > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_standing_receiver_stays_within_metres),
        cmocka_unit_test(a_solution_comes_every_fifth_of_a_second),
        cmocka_unit_test(speed_and_track_are_those_over_the_ground),
        cmocka_unit_test(speed_and_track_do_not_depend_on_the_time_between_readings),
        cmocka_unit_test(it_tells_where_the_aircraft_was_a_solution_ago),
        cmocka_unit_test(the_number_of_satellites_is_one_or_two_digits),
    };
    return cmocka_run_group_tests_name("models.sim_gps", tests, NULL, NULL);
}
