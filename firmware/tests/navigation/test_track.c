#include "support/cmocka_all.h"

#include "common/angle.h"
#include "navigation/geodesy.h"
#include "navigation/track.h"

static const double step_m = 0.6; ///< 50 Hz at 58 kt

/// Fly `steps` along `track_deg` from `at`, with `direction_deg` as what the source says; positions as the wire has
/// them, in single precision.
static float fly(track_t* track, position_t* at, float track_deg, float direction_deg, int steps)
{
    float found_deg = 0.0F;
    for (int i = 0; i < steps; i++)
    {
        const double angle_rad = (double)angle_to_rad(track_deg);
        at->latitude_deg += step_m * cos(angle_rad) / GEODESY_M_PER_DEG;
        at->longitude_deg += step_m * sin(angle_rad) / GEODESY_M_PER_DEG / cos(at->latitude_deg / 57.29578);
        const position_t wire = {(double)(float)at->latitude_deg, (double)(float)at->longitude_deg};
        found_deg = track_update(track, &wire, direction_deg, 58.0F);
    }
    return found_deg;
}

static void a_source_that_gives_the_track_comes_through(void** state)
{
    (void)state;
    track_t track;
    track_init(&track);
    position_t at = {27.95, -15.4};
    assert_close(fly(&track, &at, 40.0F, 40.0F, 3000), 40.0, 0.5);
    assert_close(fly(&track, &at, 200.0F, 200.0F, 3000), 200.0, 0.5);
}

static void a_source_that_gives_the_heading_is_corrected_by_the_drift(void** state)
{
    (void)state;
    track_t track;
    track_init(&track);
    position_t at = {27.95, -15.4};
    // the nose 15 deg into the wind, through north
    assert_close(angle_wrap_180(fly(&track, &at, 355.0F, 10.0F, 3000)), -5.0, 0.7);
}

static void the_first_answer_is_the_given_direction(void** state)
{
    (void)state;
    track_t track;
    track_init(&track);
    const position_t at = {27.95, -15.4};
    assert_close(track_update(&track, &at, -30.0F, 58.0F), 330.0, 1e-3);
}

static void a_direction_that_is_far_from_the_flight_is_no_drift(void** state)
{
    (void)state;
    track_t track;
    track_init(&track);
    position_t at = {27.95, -15.4};
    assert_close(fly(&track, &at, 170.0F, 90.0F, 3000), 90.0, 0.5); // side-ways: no aircraft
}

static void a_jump_of_the_simulator_is_no_drift(void** state)
{
    (void)state;
    track_t track;
    track_init(&track);
    position_t at = {27.95, -15.4};
    (void)fly(&track, &at, 90.0F, 90.0F, 500);
    at.latitude_deg += 0.5;
    at.longitude_deg += 1.0;
    assert_close(fly(&track, &at, 90.0F, 90.0F, 1), 90.0, 0.5);
    assert_close(fly(&track, &at, 90.0F, 90.0F, 500), 90.0, 0.5);
}

static void too_slow_to_fly_there_is_no_drift(void** state)
{
    (void)state;
    track_t track;
    track_init(&track);
    position_t at = {27.95, -15.4};
    (void)fly(&track, &at, 20.0F, 0.0F, 3000);
    assert_close(track_update(&track, &at, 0.0F, 10.0F), 0.0, 0.0);
    assert_false(track.has_anchor);
}

static void a_position_that_is_none_gives_the_direction(void** state)
{
    (void)state;
    track_t track;
    track_init(&track);
    const position_t nowhere = {(double)NAN, 0.0};
    assert_close(track_update(&track, &nowhere, 77.0F, 58.0F), 77.0, 1e-4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_source_that_gives_the_track_comes_through),
        cmocka_unit_test(a_source_that_gives_the_heading_is_corrected_by_the_drift),
        cmocka_unit_test(the_first_answer_is_the_given_direction),
        cmocka_unit_test(a_direction_that_is_far_from_the_flight_is_no_drift),
        cmocka_unit_test(a_jump_of_the_simulator_is_no_drift),
        cmocka_unit_test(too_slow_to_fly_there_is_no_drift),
        cmocka_unit_test(a_position_that_is_none_gives_the_direction),
    };
    return cmocka_run_group_tests_name("navigation.track", tests, NULL, NULL);
}
