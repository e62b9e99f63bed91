#include "support/cmocka_all.h"

#include "control/autopilot.h"

// the default gains of the protocol
static const autopilot_gains_t gains = {
    .k_altitude = 0.06F,
    .k_int_altitude_per_s = 0.06F,
    .k_vvi_ft_per_ft_min = 0.1F,
    .k_pitch = 2.0F,
    .k_heading = 0.8F,
    .k_roll = 2.0F,
    .k_div_speed_kt_s = 700.0F,
};
static const float dt_s = 0.02F;
static const double rad_per_deg = 0.017453292519943295;

// level, on course, at speed
static const autopilot_target_t target = {.altitude_ft = 1000.0F, .course_deg = 90.0F, .speed_kt = 55.0F};
static const autopilot_input_t on_target = {.altitude_ft = 1000.0F, .track_deg = 90.0F, .speed_kt = 55.0F};

static control_command_t step(autopilot_state_t* law, autopilot_input_t input)
{
    return autopilot_update(law, &gains, &target, &input, dt_s);
}

static void on_target_it_asks_for_nothing(void** state)
{
    (void)state;
    autopilot_state_t law = {.throttle = 0.6F};
    const control_command_t command = step(&law, on_target);
    assert_close(command.elevator, 0.0F, 0.0);
    assert_close(command.aileron, 0.0F, 0.0);
    assert_close(command.rudder, 0.0F, 0.0);
    assert_close(command.throttle, 0.6F, 0.0);
}

static void below_its_altitude_it_pulls_and_above_it_pushes(void** state)
{
    (void)state;
    autopilot_state_t law = {0};
    autopilot_input_t input = on_target;
    input.altitude_ft = 980.0F;
    // 20 ft * 0.06 deg/ft = 1.2 deg of pitch, twofold in rad; the integral of one step is small against it
    assert_close(step(&law, input).elevator, 2.0 * 1.2 * rad_per_deg, 1e-6);
    law = (autopilot_state_t){0};
    input.altitude_ft = 1020.0F;
    assert_close(step(&law, input).elevator, -2.0 * 1.2 * rad_per_deg, 1e-6);
}

static void the_climb_leads_the_altitude(void** state)
{
    (void)state;
    autopilot_state_t law = {0};
    autopilot_input_t input = on_target;
    input.altitude_ft = 950.0F;
    input.vvi_ft_min = 500.0F; // 0.1 ft per ft/min: as good as there
    assert_close(step(&law, input).elevator, 0.0, 1e-6);
}

static void pitch_and_elevator_stop_at_their_limits(void** state)
{
    (void)state;
    autopilot_state_t law = {0};
    autopilot_input_t input = on_target;
    input.altitude_ft = -5000.0F;
    input.pitch_deg = 15.0F; // the highest pitch it ever asks for
    assert_close(step(&law, input).elevator, 0.0, 1e-6);
    input.pitch_deg = 0.0F;
    assert_close(step(&law, input).elevator, 0.1F, 0.0);
    input.altitude_ft = 9000.0F;
    input.pitch_deg = -20.0F;
    assert_close(step(&law, input).elevator, 0.0, 1e-6);
    input.pitch_deg = 0.0F;
    assert_close(step(&law, input).elevator, -0.1F, 0.0);
}

static void the_altitude_integral_works_only_near_the_altitude(void** state)
{
    (void)state;
    autopilot_state_t law = {0};
    autopilot_input_t input = on_target;
    input.altitude_ft = 901.0F;
    for (int i = 0; i < 50; i++)
    {
        (void)step(&law, input);
    }
    assert_close(law.altitude_integral_deg, 0.06 * 0.06 * 99.0, 1e-4);
    input.altitude_ft = 899.0F;
    const float before_deg = law.altitude_integral_deg;
    (void)step(&law, input);
    assert_close(law.altitude_integral_deg, before_deg, 0.0);
}

static void the_altitude_integral_ends_at_ten_degrees(void** state)
{
    (void)state;
    autopilot_state_t law = {0};
    autopilot_input_t input = on_target;
    input.altitude_ft = 940.0F;
    for (int i = 0; i < 20000; i++)
    {
        (void)step(&law, input);
    }
    assert_close(law.altitude_integral_deg, 10.0F, 0.0);
    input.altitude_ft = 1060.0F;
    for (int i = 0; i < 40000; i++)
    {
        (void)step(&law, input);
    }
    assert_close(law.altitude_integral_deg, -10.0F, 0.0);
}

static void the_altitude_integral_does_not_push_further_into_the_pitch_limit(void** state)
{
    (void)state;
    // 90 ft below while sinking: 0.06 * 240 + 5 is more than the 15 deg that are allowed
    autopilot_state_t law = {.altitude_integral_deg = 5.0F};
    autopilot_input_t input = on_target;
    input.altitude_ft = 910.0F;
    input.vvi_ft_min = -1500.0F;
    (void)step(&law, input);
    assert_close(law.altitude_integral_deg, 5.0F, 0.0);
    // the other way it works at once
    law.altitude_integral_deg = 10.0F;
    input.altitude_ft = 1090.0F;
    input.vvi_ft_min = 0.0F;
    (void)step(&law, input);
    assert_true(law.altitude_integral_deg < 10.0F);
}

static void it_turns_the_short_way_round(void** state)
{
    (void)state;
    autopilot_state_t law = {0};
    autopilot_input_t input = on_target;
    const autopilot_target_t north = {.altitude_ft = 1000.0F, .course_deg = 10.0F, .speed_kt = 55.0F};
    input.track_deg = 350.0F;
    // 20 deg to the right: 16 deg of roll, twofold in rad
    assert_close(autopilot_update(&law, &gains, &north, &input, dt_s).aileron, 2.0 * 16.0 * rad_per_deg, 1e-5);
    input.track_deg = 30.0F;
    assert_close(autopilot_update(&law, &gains, &north, &input, dt_s).aileron, -2.0 * 16.0 * rad_per_deg, 1e-5);
}

static void roll_and_aileron_stop_at_their_limits(void** state)
{
    (void)state;
    autopilot_state_t law = {0};
    autopilot_input_t input = on_target;
    input.track_deg = 0.0F;
    input.roll_deg = 30.0F; // the steepest bank it ever asks for
    assert_close(step(&law, input).aileron, 0.0, 1e-6);
    input.roll_deg = 0.0F;
    assert_close(step(&law, input).aileron, 0.7F, 0.0);
    input.track_deg = 180.0F;
    assert_close(step(&law, input).aileron, -0.7F, 0.0);
}

static void the_throttle_integrates_the_speed_error_between_its_stops(void** state)
{
    (void)state;
    autopilot_state_t law = {.throttle = 0.5F};
    autopilot_input_t input = on_target;
    input.speed_kt = 48.0F;
    for (int i = 0; i < 50; i++)
    {
        (void)step(&law, input);
    }
    assert_close(law.throttle, 0.5 + 7.0 / 700.0, 1e-5); // 1 s
    for (int i = 0; i < 10000; i++)
    {
        (void)step(&law, input);
    }
    assert_close(law.throttle, 1.0F, 0.0);
    input.speed_kt = 90.0F;
    assert_true(step(&law, input).throttle < 1.0F);
    for (int i = 0; i < 10000; i++)
    {
        (void)step(&law, input);
    }
    assert_close(law.throttle, 0.0F, 0.0);
}

static void frozen_nothing_is_integrated(void** state)
{
    (void)state;
    autopilot_state_t law = {.altitude_integral_deg = 2.0F, .throttle = 0.8F};
    autopilot_input_t input = on_target;
    input.altitude_ft = 950.0F;
    input.speed_kt = 10.0F;
    input.frozen = true;
    for (int i = 0; i < 1000; i++)
    {
        (void)step(&law, input);
    }
    assert_close(law.altitude_integral_deg, 2.0F, 0.0);
    assert_close(law.throttle, 0.8F, 0.0);
}

static void switching_on_starts_from_the_throttle_and_the_level_attitude_of_that_moment(void** state)
{
    (void)state;
    autopilot_state_t law = {0};
    autopilot_input_t input = on_target;
    input.pitch_deg = 4.0F;
    autopilot_engage(&law, &input, 0.62F);
    assert_close(law.throttle, 0.62F, 0.0);
    assert_close(law.altitude_integral_deg, 4.0, 1e-6);
    assert_close(step(&law, input).elevator, 0.0, 1e-6);
    // climbing at 6 deg with 9 deg of pitch: level flight needs 3 deg
    input.pitch_deg = 9.0F;
    input.vvi_ft_min = 55.0F * 101.2686F * 0.10510F;
    autopilot_engage(&law, &input, 2.0F);
    assert_close(law.altitude_integral_deg, 3.0, 0.01);
    assert_close(law.throttle, 1.0F, 0.0);
    input.speed_kt = 0.0F; // and standing still is no division by zero
    autopilot_engage(&law, &input, 0.0F);
    assert_close(law.altitude_integral_deg, 9.0, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_target_it_asks_for_nothing),
        cmocka_unit_test(below_its_altitude_it_pulls_and_above_it_pushes),
        cmocka_unit_test(the_climb_leads_the_altitude),
        cmocka_unit_test(pitch_and_elevator_stop_at_their_limits),
        cmocka_unit_test(the_altitude_integral_works_only_near_the_altitude),
        cmocka_unit_test(the_altitude_integral_ends_at_ten_degrees),
        cmocka_unit_test(the_altitude_integral_does_not_push_further_into_the_pitch_limit),
        cmocka_unit_test(it_turns_the_short_way_round),
        cmocka_unit_test(roll_and_aileron_stop_at_their_limits),
        cmocka_unit_test(the_throttle_integrates_the_speed_error_between_its_stops),
        cmocka_unit_test(frozen_nothing_is_integrated),
        cmocka_unit_test(switching_on_starts_from_the_throttle_and_the_level_attitude_of_that_moment),
    };
    return cmocka_run_group_tests_name("control.autopilot", tests, NULL, NULL);
}
