#include "support/cmocka_all.h"

#include "navigation/geodesy.h"
#include "sim_motion.h"

static const sim_truth_t gando = {
    .latitude_deg = 27.9319, .longitude_deg = -15.3866, .altitude_m = 20.0F, .yaw_deg = 28.0F};

/// Tell `commands` times that the aircraft went `north_m` and `east_m` further.
static void tell(sim_motion_t* motion, sim_truth_t* truth, int commands, float north_m, float east_m)
{
    for (int i = 0; i < commands; i++)
    {
        truth->latitude_deg += (double)north_m / GEODESY_M_PER_DEG;
        truth->longitude_deg += (double)east_m / (GEODESY_M_PER_DEG * 0.88351);
        sim_motion_follow(motion, truth);
    }
}

static void an_aircraft_that_stands_has_no_ground_speed_and_points_along_its_nose(void** state)
{
    (void)state;
    sim_motion_t motion = {.told = 0};
    sim_truth_t truth = gando;
    truth.airspeed_m_s = 5.0F; // a wind blows
    tell(&motion, &truth, 200, 0.0F, 0.0F);
    assert_close(truth.ground_speed_m_s, 0.0, 0.0);
    assert_close(truth.track_deg, 28.0, 0.0);
}

static void the_speed_is_the_airspeed_however_far_apart_two_commands_are(void** state)
{
    (void)state;
    static const float steps_m[] = {0.2F, 0.6F, 2.0F, 60.0F};
    for (size_t i = 0; i < sizeof steps_m / sizeof steps_m[0]; i++)
    {
        sim_motion_t motion = {.told = 0};
        sim_truth_t truth = gando;
        truth.airspeed_m_s = 30.0F;
        tell(&motion, &truth, 100, steps_m[i], 0.0F);
        assert_close(truth.ground_speed_m_s, 30.0, 0.1);
    }
}

static void the_same_airspeed_is_a_higher_speed_in_thin_air(void** state)
{
    (void)state;
    sim_motion_t motion = {.told = 0};
    sim_truth_t truth = gando;
    truth.airspeed_m_s = 30.0F;
    truth.altitude_m = 3000.0F; // 0.7423 of the density at sea level, says the table of the standard atmosphere
    tell(&motion, &truth, 100, 0.6F, 0.0F);
    assert_close(truth.ground_speed_m_s, 30.0 / sqrt(0.7423), 0.05);
}

static void climbing_is_no_ground_speed(void** state)
{
    (void)state;
    sim_motion_t motion = {.told = 0};
    sim_truth_t truth = gando;
    truth.altitude_m = 0.0F;
    truth.airspeed_m_s = 30.0F;
    truth.climb_m_s = 18.0F;
    tell(&motion, &truth, 100, 0.6F, 0.0F);
    assert_close(truth.ground_speed_m_s, 24.0, 0.01);
    truth.climb_m_s = -40.0F;
    tell(&motion, &truth, 1, 0.6F, 0.0F);
    assert_close(truth.ground_speed_m_s, 0.0, 0.0);
}

static void the_track_is_the_direction_of_the_way_not_of_the_nose(void** state)
{
    (void)state;
    sim_motion_t motion = {.told = 0};
    sim_truth_t truth = gando;
    truth.airspeed_m_s = 30.0F;
    tell(&motion, &truth, 100, -0.5F, 0.5F);
    assert_close(truth.track_deg, 135.0, 0.5);
    // sixty commands later nothing is left of the old direction
    tell(&motion, &truth, 60, 0.0F, -0.5F);
    assert_close(truth.track_deg, 270.0, 0.5);
}

static void the_track_of_an_aircraft_that_stops_stays(void** state)
{
    (void)state;
    sim_motion_t motion = {.told = 0};
    sim_truth_t truth = gando;
    truth.airspeed_m_s = 10.0F;
    tell(&motion, &truth, 100, 0.0F, 0.5F);
    tell(&motion, &truth, 100, 0.0F, 0.0F);
    assert_close(truth.ground_speed_m_s, 0.0, 0.0);
    assert_close(truth.track_deg, 90.0, 0.5);
}

static void being_moved_elsewhere_is_no_flight(void** state)
{
    (void)state;
    sim_motion_t motion = {.told = 0};
    sim_truth_t truth = gando;
    truth.airspeed_m_s = 30.0F;
    tell(&motion, &truth, 100, 0.6F, 0.0F);
    truth.latitude_deg = 40.0;
    truth.yaw_deg = 90.0F;
    sim_motion_follow(&motion, &truth);
    assert_close(truth.ground_speed_m_s, 0.0, 0.0);
    assert_close(truth.track_deg, 90.0, 0.0);
    tell(&motion, &truth, 10, 0.0F, 0.6F);
    assert_close(truth.ground_speed_m_s, 30.0, 0.1);
    assert_close(truth.track_deg, 90.0, 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_aircraft_that_stands_has_no_ground_speed_and_points_along_its_nose),
        cmocka_unit_test(the_speed_is_the_airspeed_however_far_apart_two_commands_are),
        cmocka_unit_test(the_same_airspeed_is_a_higher_speed_in_thin_air),
        cmocka_unit_test(climbing_is_no_ground_speed),
        cmocka_unit_test(the_track_is_the_direction_of_the_way_not_of_the_nose),
        cmocka_unit_test(the_track_of_an_aircraft_that_stops_stays),
        cmocka_unit_test(being_moved_elsewhere_is_no_flight),
    };
    return cmocka_run_group_tests_name("models.sim_motion", tests, NULL, NULL);
}
