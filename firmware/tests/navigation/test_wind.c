#include "support/cmocka_all.h"

#include "common/angle.h"
#include "navigation/geodesy.h"
#include "navigation/wind.h"

static const double north_m_s = -9.0; ///< the real wind, 25 kt
static const double east_m_s = 9.0;
static const double airspeed_m_s = 28.0;
static const double dt_s = 0.02;

/// Fly on for `seconds`, turning; positions as the wire has them, in single precision.
static void fly(wind_t* wind, position_t* at, double* heading_deg, double turn_deg_s, double seconds)
{
    for (int i = 0; i < (int)(seconds / dt_s); i++)
    {
        *heading_deg += turn_deg_s * dt_s;
        const double heading_rad = (double)angle_to_rad((float)*heading_deg);
        const double shrink = cos((double)angle_to_rad((float)at->latitude_deg));
        at->latitude_deg += (airspeed_m_s * cos(heading_rad) + north_m_s) * dt_s / GEODESY_M_PER_DEG;
        at->longitude_deg += (airspeed_m_s * sin(heading_rad) + east_m_s) * dt_s / GEODESY_M_PER_DEG / shrink;
        const position_t wire = {(double)(float)at->latitude_deg, (double)(float)at->longitude_deg};
        wind_update(wind, &wire, (float)airspeed_m_s, (float)dt_s);
    }
}

static void the_component_along_the_way_is_known_in_straight_flight(void** state)
{
    (void)state;
    wind_t wind;
    wind_init(&wind);
    position_t at = {27.95, -15.4};
    double heading_deg = 135.0; // the wind from behind
    fly(&wind, &at, &heading_deg, 0.0, 20.0);
    assert_close(wind_ground_speed_m_s(&wind, (float)airspeed_m_s, 135.0F), 28.0 + hypot(north_m_s, east_m_s), 0.3);
}

static void a_turn_brings_the_whole_wind(void** state)
{
    (void)state;
    wind_t wind;
    wind_init(&wind);
    position_t at = {27.95, -15.4};
    double heading_deg = 10.0;
    fly(&wind, &at, &heading_deg, 0.0, 10.0);
    fly(&wind, &at, &heading_deg, 10.0, 12.0);
    fly(&wind, &at, &heading_deg, 0.0, 10.0);
    assert_close(wind.north_m_s, north_m_s, 2.0);
    assert_close(wind.east_m_s, east_m_s, 2.0);
    fly(&wind, &at, &heading_deg, -10.0, 12.0);
    fly(&wind, &at, &heading_deg, 0.0, 10.0);
    assert_close(wind.north_m_s, north_m_s, 1.0);
    assert_close(wind.east_m_s, east_m_s, 1.0);
}

static void the_heading_goes_into_the_wind(void** state)
{
    (void)state;
    wind_t wind;
    wind_init(&wind);
    wind.east_m_s = 14.0F; // blows to the east
    assert_close(wind_heading_deg(&wind, 28.0F, 0.0F), -30.0, 0.01);
    assert_close(wind_ground_speed_m_s(&wind, 28.0F, 0.0F), 24.25, 0.01);
    assert_close(wind_ground_speed_m_s(&wind, 28.0F, 90.0F), 42.0, 0.01);
    assert_close(wind_ground_speed_m_s(&wind, 28.0F, 270.0F), 14.0, 0.01);
}

static void a_wind_stronger_than_the_aircraft_leaves_no_ground_speed(void** state)
{
    (void)state;
    wind_t wind;
    wind_init(&wind);
    wind.north_m_s = 40.0F;
    assert_close(wind_ground_speed_m_s(&wind, 28.0F, 180.0F), 0.0, 0.0);
    assert_true(isfinite(wind_heading_deg(&wind, 28.0F, 90.0F)));
}

static void a_pause_or_a_lost_position_is_no_wind(void** state)
{
    (void)state;
    wind_t wind;
    wind_init(&wind);
    position_t at = {27.95, -15.4};
    double heading_deg = 10.0;
    fly(&wind, &at, &heading_deg, 10.0, 36.0);
    const wind_t before = wind;
    const position_t nowhere = {(double)NAN, -15.4};
    wind_update(&wind, &nowhere, 28.0F, 0.02F);
    at.latitude_deg += 0.01;
    wind_update(&wind, &at, 28.0F, 0.02F);
    at.latitude_deg += 0.01;
    wind_update(&wind, &at, 28.0F, 0.0F);
    assert_close(wind.north_m_s, before.north_m_s, 0.0);
    assert_close(wind.east_m_s, before.east_m_s, 0.0);
}

static void the_wind_is_told_from_where_it_blows_and_how_sure_it_is(void** state)
{
    (void)state;
    wind_t wind;
    wind_init(&wind);
    wind_estimate_t estimate;
    position_t at = {27.95, -15.4};
    double heading_deg = 10.0;
    assert_false(wind_estimate(&wind, &estimate));
    wind_update(&wind, &at, 28.0F, 0.02F);
    assert_false(wind_estimate(&wind, &estimate));
    fly(&wind, &at, &heading_deg, 0.0, 10.0);
    assert_true(wind_estimate(&wind, &estimate));
    const float before_m_s = estimate.deviation_m_s; // the wind across the track is not known yet
    assert_true(before_m_s > 5.0F);
    fly(&wind, &at, &heading_deg, 10.0, 12.0);
    fly(&wind, &at, &heading_deg, -10.0, 12.0);
    fly(&wind, &at, &heading_deg, 0.0, 10.0);
    assert_true(wind_estimate(&wind, &estimate));
    assert_close(estimate.from_deg, 315.0, 5.0);
    assert_close(estimate.speed_m_s, hypot(north_m_s, east_m_s), 1.0);
    assert_true(estimate.deviation_m_s < 0.5F * before_m_s);
    const position_t nowhere = {(double)NAN, (double)NAN};
    wind_update(&wind, &nowhere, 28.0F, 0.02F);
    assert_false(wind_estimate(&wind, &estimate));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_component_along_the_way_is_known_in_straight_flight),
        cmocka_unit_test(a_turn_brings_the_whole_wind),
        cmocka_unit_test(the_heading_goes_into_the_wind),
        cmocka_unit_test(a_wind_stronger_than_the_aircraft_leaves_no_ground_speed),
        cmocka_unit_test(a_pause_or_a_lost_position_is_no_wind),
        cmocka_unit_test(the_wind_is_told_from_where_it_blows_and_how_sure_it_is),
    };
    return cmocka_run_group_tests_name("navigation.wind", tests, NULL, NULL);
}
