#include "support/cmocka_all.h"

#include "navigation/geodesy.h"

static const position_t gando = {27.9319, -15.3866};

static void distances_agree_with_the_sphere(void** state)
{
    (void)state;
    // one degree of a meridian of a sphere of 6371008.8 m
    const position_t north = {28.9319, -15.3866};
    assert_close(geodesy_distance_m(&gando, &north), 111195.08, 1.0);
    // one degree along the equator, across the date line
    const position_t west = {0.0, 179.5};
    const position_t east = {0.0, -179.5};
    assert_close(geodesy_distance_m(&west, &east), 111195.08, 1.0);
    assert_close(geodesy_distance_m(&east, &west), 111195.08, 1.0);
    assert_close(geodesy_bearing_deg(&west, &east), 90.0, 0.01);
    assert_close(geodesy_bearing_deg(&east, &west), 270.0, 0.01);
    // half way round
    const position_t pole = {90.0, 0.0};
    const position_t other = {-90.0, 0.0};
    assert_close(geodesy_distance_m(&pole, &other), 20015114.0, 5.0);
}

static void short_distances_keep_their_precision(void** state)
{
    (void)state;
    const position_t near = {27.9319 + 1e-6, -15.3866};
    assert_close(geodesy_distance_m(&gando, &near), 0.1112, 0.0005);
    assert_close(geodesy_distance_m(&gando, &gando), 0.0, 0.0);
}

static void bearings_are_clockwise_from_north(void** state)
{
    (void)state;
    const position_t north = {28.0, -15.3866};
    const position_t south = {27.0, -15.3866};
    assert_close(geodesy_bearing_deg(&gando, &north), 0.0, 1e-3);
    assert_close(geodesy_bearing_deg(&gando, &south), 180.0, 1e-3);
    const position_t equator = {0.0, 10.0};
    const position_t east = {0.0, 11.0};
    const position_t west = {0.0, 9.0};
    assert_close(geodesy_bearing_deg(&equator, &east), 90.0, 1e-3);
    assert_close(geodesy_bearing_deg(&equator, &west), 270.0, 1e-3);
}

static void a_great_circle_leaves_at_its_initial_bearing(void** state)
{
    (void)state;
    // Madrid to New York; by the formula of the sphere in double precision
    const position_t madrid = {40.4168, -3.7038};
    const position_t new_york = {40.7128, -74.0060};
    assert_close(geodesy_bearing_deg(&madrid, &new_york), 294.8803, 0.001);
    assert_close(geodesy_distance_m(&madrid, &new_york), 5768012.2, 5.0);
}

static void the_same_place_has_a_bearing_all_the_same(void** state)
{
    (void)state;
    assert_close(geodesy_bearing_deg(&gando, &gando), 0.0, 0.0);
}

static void what_is_no_place_is_not_valid(void** state)
{
    (void)state;
    const position_t places[] = {{91.0, 0.0}, {-90.1, 0.0}, {0.0, 180.5}, {(double)NAN, 0.0}, {0.0, (double)INFINITY}};
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++)
    {
        assert_false(position_is_valid(&places[i]));
    }
    assert_true(position_is_valid(&gando));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_agree_with_the_sphere),
        cmocka_unit_test(short_distances_keep_their_precision),
        cmocka_unit_test(bearings_are_clockwise_from_north),
        cmocka_unit_test(a_great_circle_leaves_at_its_initial_bearing),
        cmocka_unit_test(the_same_place_has_a_bearing_all_the_same),
        cmocka_unit_test(what_is_no_place_is_not_valid),
    };
    return cmocka_run_group_tests_name("navigation.geodesy", tests, NULL, NULL);
}
