#include "support/cmocka_all.h"

#include <stdbool.h>

#include "common/angle.h"
#include "common/units.h"
#include "estimation/attitude.h"
#include "estimation/gravity.h"

static const float step_s = 0.02F;

/// What perfect sensors measure in a steady turn (or straight on, without bank) at this attitude.
static attitude_input_t steady(euler_t attitude, float airspeed_m_s)
{
    const rotation_t body = rotation_from_euler(attitude);
    const float turn_rad_s =
        airspeed_m_s > 0.0F ? GRAVITY_M_S2 * tanf(angle_to_rad(attitude.roll_deg)) / airspeed_m_s : 0.0F;
    const vector_t rate = rotation_to_body(body, (vector_t){.z = turn_rad_s});
    const vector_t flight = vector_cross(rate, (vector_t){.x = airspeed_m_s});
    const vector_t gravity = rotation_to_body(body, (vector_t){.z = GRAVITY_M_S2});
    const vector_t field = {.x = 0.79F, .z = 0.62F};
    return (attitude_input_t){
        .rate_rad_s = rate,
        .has_rate = true,
        .force_m_s2 = vector_difference(flight, gravity),
        .has_force = true,
        .field = rotation_to_body(body, field),
        .has_field = true,
        .airspeed_m_s = airspeed_m_s,
        .has_airspeed = true,
    };
}

/// Fly so for `seconds`, turning on as the bank says; returns the attitude at the end.
static euler_t fly(attitude_filter_t* filter, euler_t attitude, float airspeed_m_s, float seconds,
                   attitude_input_t (*sensors)(attitude_input_t perfect))
{
    const float turn_rad_s =
        airspeed_m_s > 0.0F ? GRAVITY_M_S2 * tanf(angle_to_rad(attitude.roll_deg)) / airspeed_m_s : 0.0F;
    for (float t = 0.0F; t < seconds; t += step_s)
    {
        const attitude_input_t perfect = steady(attitude, airspeed_m_s);
        const attitude_input_t input = sensors == NULL ? perfect : sensors(perfect);
        attitude_update(filter, &input, step_s);
        attitude.yaw_deg = angle_wrap_360(attitude.yaw_deg + angle_to_deg(turn_rad_s * step_s));
    }
    return attitude;
}

static attitude_input_t biased(attitude_input_t perfect)
{
    perfect.rate_rad_s = vector_sum(perfect.rate_rad_s, (vector_t){0.02F, -0.03F, 0.015F});
    return perfect;
}

static attitude_input_t without_gyro(attitude_input_t perfect)
{
    perfect.has_rate = false;
    return perfect;
}

static attitude_input_t without_compass(attitude_input_t perfect)
{
    perfect.has_field = false;
    return perfect;
}

static attitude_input_t beside_a_magnet(attitude_input_t perfect)
{
    perfect.field = vector_sum(perfect.field, (vector_t){0.1F, 0.3F, -0.2F});
    return perfect;
}

static attitude_input_t shaken(attitude_input_t perfect)
{
    perfect.force_m_s2 = vector_sum(perfect.force_m_s2, (vector_t){12.0F, 9.0F, 0.0F});
    return perfect;
}

static void assert_attitude(const attitude_filter_t* filter, euler_t expected, float tolerance_deg)
{
    const euler_t angles = rotation_to_euler(filter->body);
    assert_close(angle_wrap_180(angles.yaw_deg - expected.yaw_deg), 0.0, tolerance_deg);
    assert_close(angles.pitch_deg, expected.pitch_deg, tolerance_deg);
    assert_close(angle_wrap_180(angles.roll_deg - expected.roll_deg), 0.0, tolerance_deg);
}

static void the_first_samples_align_it_in_any_attitude(void** state)
{
    (void)state;
    const euler_t attitudes[] = {
        {0.0F, 0.0F, 0.0F}, {300.0F, 15.0F, -40.0F}, {90.0F, -60.0F, 10.0F}, {180.0F, 0.0F, 170.0F}};
    for (size_t i = 0; i < sizeof attitudes / sizeof attitudes[0]; i++)
    {
        attitude_filter_t filter;
        attitude_init(&filter);
        assert_false(filter.has_tilt);
        (void)fly(&filter, attitudes[i], 0.0F, 0.3F, NULL);
        assert_true(filter.has_tilt && filter.has_heading);
        // standing at a bank the body does not turn, so there is nothing to correct
        assert_attitude(&filter, attitudes[i], 0.5F);
    }
}

static void it_aligns_in_the_middle_of_a_turn_too(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    const euler_t end = fly(&filter, (euler_t){40.0F, 3.0F, 30.0F}, 28.0F, 0.5F, NULL);
    assert_attitude(&filter, end, 2.0F);
}

static void level_flight_stays_level_and_on_its_true_heading(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    const euler_t end = fly(&filter, (euler_t){250.0F, 2.0F, 0.0F}, 28.0F, 60.0F, NULL);
    assert_attitude(&filter, end, 0.1F);
}

static void five_minutes_of_banked_turn_do_not_tilt_the_horizon(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    euler_t attitude = fly(&filter, (euler_t){10.0F, 0.0F, 0.0F}, 28.0F, 10.0F, NULL);
    attitude.roll_deg = -30.0F;
    for (int minute = 0; minute < 5; minute++)
    {
        attitude = fly(&filter, attitude, 28.0F, 60.0F, NULL);
        assert_attitude(&filter, attitude, 1.0F);
    }
}

static void a_gyros_bias_is_learnt(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    const euler_t end = fly(&filter, (euler_t){120.0F, 3.0F, 0.0F}, 28.0F, 120.0F, biased);
    assert_close(filter.bias_rad_s.x, 0.02, 0.001);
    assert_close(filter.bias_rad_s.y, -0.03, 0.001);
    assert_close(filter.bias_rad_s.z, 0.015, 0.001);
    assert_close(filter.rate_rad_s.y, 0.0, 0.001);
    assert_attitude(&filter, end, 0.5F);
}

static void a_roll_is_followed_at_once(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    euler_t attitude = fly(&filter, (euler_t){120.0F, 0.0F, 0.0F}, 28.0F, 20.0F, NULL);
    for (int i = 0; i < 50; i++)
    {
        attitude.roll_deg += 0.8F; // 40 degrees in a second
        attitude_input_t input = steady(attitude, 28.0F);
        input.rate_rad_s.x += angle_to_rad(40.0F);
        attitude_update(&filter, &input, step_s);
    }
    assert_close(rotation_to_euler(filter.body).roll_deg, 40.0, 1.0);
}

static void ten_seconds_without_a_gyro_in_a_turn_are_survived_and_forgotten(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    euler_t attitude = fly(&filter, (euler_t){120.0F, 0.0F, 25.0F}, 28.0F, 30.0F, biased);
    const vector_t bias = filter.bias_rad_s;
    attitude = fly(&filter, attitude, 28.0F, 10.0F, without_gyro);
    assert_false(attitude_has_rate(&filter));
    assert_attitude(&filter, attitude, 6.0F);
    assert_close(vector_length(vector_difference(filter.bias_rad_s, bias)), 0.0, 1e-4);
    attitude = fly(&filter, attitude, 28.0F, 5.0F, biased);
    assert_true(attitude_has_rate(&filter));
    assert_attitude(&filter, attitude, 1.5F);
}

static void a_turn_that_ends_while_gyro_and_compass_are_silent_is_not_turned_on(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    euler_t attitude = fly(&filter, (euler_t){120.0F, 0.0F, 25.0F}, 28.0F, 30.0F, NULL);
    for (int i = 0; i < 500; i++)
    {
        attitude_input_t input = without_gyro(without_compass(steady(attitude, 28.0F)));
        attitude_update(&filter, &input, step_s);
    }
    const float before_deg = rotation_to_euler(filter.body).yaw_deg;
    for (int i = 0; i < 50; i++)
    {
        attitude_input_t input = without_gyro(without_compass(steady(attitude, 28.0F)));
        attitude_update(&filter, &input, step_s);
    }
    assert_close(angle_wrap_180(rotation_to_euler(filter.body).yaw_deg - before_deg), 0.0, 0.1);
}

static void a_disturbed_compass_turns_the_heading_but_does_not_tilt_the_horizon(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    const euler_t standing = fly(&filter, (euler_t){120.0F, 5.0F, 0.0F}, 0.0F, 20.0F, NULL);
    (void)fly(&filter, standing, 0.0F, 30.0F, beside_a_magnet);
    const euler_t angles = rotation_to_euler(filter.body);
    assert_true(fabsf(angle_wrap_180(angles.yaw_deg - standing.yaw_deg)) > 5.0F);
    assert_close(angles.pitch_deg, standing.pitch_deg, 0.1);
    assert_close(angles.roll_deg, standing.roll_deg, 0.1);
    // In flight the yaw rate's bias, which is learnt from the wrong heading, adds a little.
    attitude_init(&filter);
    const euler_t flying = fly(&filter, (euler_t){120.0F, 5.0F, 0.0F}, 28.0F, 20.0F, NULL);
    (void)fly(&filter, flying, 28.0F, 30.0F, beside_a_magnet);
    assert_close(rotation_to_euler(filter.body).roll_deg, 0.0, 1.5);
}

static void forces_far_from_gravity_are_not_taken_for_it(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    const euler_t end = fly(&filter, (euler_t){120.0F, 0.0F, 0.0F}, 28.0F, 20.0F, NULL);
    (void)fly(&filter, end, 28.0F, 5.0F, shaken);
    assert_attitude(&filter, end, 0.2F);
}

static void without_a_compass_the_horizon_is_known_and_the_heading_is_not(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    const euler_t end = fly(&filter, (euler_t){120.0F, 4.0F, 0.0F}, 28.0F, 5.0F, without_compass);
    assert_true(filter.has_tilt);
    assert_false(filter.has_heading);
    assert_close(rotation_to_euler(filter.body).pitch_deg, 4.0, 0.2);
    (void)fly(&filter, end, 28.0F, 0.05F, NULL);
    assert_true(filter.has_heading);
    assert_attitude(&filter, end, 0.5F);
}

static void an_aircraft_that_was_put_somewhere_else_is_found_again_within_seconds(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    (void)fly(&filter, (euler_t){28.0F, 0.0F, 0.0F}, 0.0F, 30.0F, NULL);
    const euler_t elsewhere = {205.0F, -5.0F, 120.0F};
    (void)fly(&filter, elsewhere, 0.0F, 8.0F, NULL);
    assert_attitude(&filter, elsewhere, 2.0F);
}

static void an_aircraft_put_into_flight_from_a_standstill_is_not_taken_for_a_catapulted_one(void** state)
{
    (void)state;
    attitude_filter_t filter;
    attitude_init(&filter);
    (void)fly(&filter, (euler_t){28.0F, 0.0F, 0.0F}, 0.0F, 1.0F, NULL);
    const euler_t flying = {28.0F, 3.0F, 0.0F};
    (void)fly(&filter, flying, 28.0F, 1.5F, NULL);
    assert_attitude(&filter, flying, 1.0F);
    assert_close(vector_length(filter.bias_rad_s), 0.0, 0.005);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_samples_align_it_in_any_attitude),
        cmocka_unit_test(it_aligns_in_the_middle_of_a_turn_too),
        cmocka_unit_test(level_flight_stays_level_and_on_its_true_heading),
        cmocka_unit_test(five_minutes_of_banked_turn_do_not_tilt_the_horizon),
        cmocka_unit_test(a_gyros_bias_is_learnt),
        cmocka_unit_test(a_roll_is_followed_at_once),
        cmocka_unit_test(ten_seconds_without_a_gyro_in_a_turn_are_survived_and_forgotten),
        cmocka_unit_test(a_turn_that_ends_while_gyro_and_compass_are_silent_is_not_turned_on),
        cmocka_unit_test(a_disturbed_compass_turns_the_heading_but_does_not_tilt_the_horizon),
        cmocka_unit_test(forces_far_from_gravity_are_not_taken_for_it),
        cmocka_unit_test(without_a_compass_the_horizon_is_known_and_the_heading_is_not),
        cmocka_unit_test(an_aircraft_that_was_put_somewhere_else_is_found_again_within_seconds),
        cmocka_unit_test(an_aircraft_put_into_flight_from_a_standstill_is_not_taken_for_a_catapulted_one),
    };
    return cmocka_run_group_tests_name("estimation.attitude", tests, NULL, NULL);
}
