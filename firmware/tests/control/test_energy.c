#include "support/cmocka_all.h"

#include "control/energy.h"

static const energy_gains_t gains = {
    .k_climb_per_s = 0.5F,
    .k_path = 1.0F,
    .k_int_path_per_s = 0.3F,
    .k_pitch = 2.0F,
    .k_accelerate_per_s = 0.3F,
    .k_feed_s_per_m = 0.04F,
    .k_energy_s_per_m = 0.03F,
    .k_int_energy_per_m = 0.02F,
    .climb_limit_ft_min = 800.0F,
    .sink_limit_ft_min = 500.0F,
    .load_limit_g = 1.0F,
};
static const energy_target_t target = {.altitude_ft = 1000.0F, .speed_kt = 55.0F};
static const energy_input_t level = {
    .altitude_ft = 1000.0F, .pitch_deg = 3.0F, .speed_kt = 55.0F, .rate_per_command_rad_s = 2.1F};
static const float dt_s = 0.02F;

static energy_state_t engaged(const energy_input_t* input)
{
    energy_state_t law;
    energy_engage(&law, input, 0.4F);
    return law;
}

static energy_command_t settle(energy_state_t* law, const energy_input_t* input, double seconds)
{
    energy_command_t command = {0};
    for (int i = 0; i < (int)(seconds / (double)dt_s); i++)
    {
        command = energy_update(law, &gains, &target, input, dt_s);
    }
    return command;
}

static void on_target_it_keeps_what_it_found(void** state)
{
    (void)state;
    energy_state_t law = engaged(&level);
    const energy_command_t command = settle(&law, &level, 5.0);
    assert_close(command.elevator, 0.0, 1e-5);
    assert_close(command.throttle, 0.4, 1e-4);
}

static void too_low_it_pulls_and_gives_throttle_and_too_high_the_opposite(void** state)
{
    (void)state;
    energy_input_t input = level;
    input.altitude_ft = 980.0F;
    energy_state_t law = engaged(&input);
    energy_command_t command = settle(&law, &input, 1.0);
    assert_true(command.elevator > 0.02F);
    assert_true(command.throttle > 0.45F);
    input.altitude_ft = 1020.0F;
    law = engaged(&input);
    command = settle(&law, &input, 1.0);
    assert_true(command.elevator < -0.02F);
    assert_true(command.throttle < 0.35F);
}

static void too_slow_is_the_throttles_business(void** state)
{
    (void)state;
    energy_input_t input = level;
    input.speed_kt = 52.0F;
    energy_state_t law = engaged(&input);
    const energy_command_t command = settle(&law, &input, 1.0);
    assert_true(command.throttle > 0.45F);
    assert_close(command.elevator, 0.0, 1e-3);
}

static void the_climb_keeps_its_limits(void** state)
{
    (void)state;
    energy_input_t input = level;
    input.altitude_ft = -5000.0F;
    energy_state_t law = engaged(&input);
    (void)settle(&law, &input, 5.0);
    assert_close(law.climb_d_m_s, 800.0 * 0.00508, 1e-3);
    input.altitude_ft = 9000.0F;
    law = engaged(&input);
    (void)settle(&law, &input, 5.0);
    assert_close(law.climb_d_m_s, -500.0 * 0.00508, 1e-3);
}

static void without_power_in_hand_the_speed_comes_before_the_climb_and_it_is_told(void** state)
{
    (void)state;
    energy_input_t input = level;
    input.altitude_ft = 500.0F;
    input.speed_kt = 42.0F;
    energy_state_t law = engaged(&input);
    (void)settle(&law, &input, 15.0);
    assert_close(law.throttle, 1.0, 0.0);
    assert_true(law.is_limited);
    assert_true(law.climb_d_m_s < 1.0F);
}

static void a_turn_is_pulled_for(void** state)
{
    (void)state;
    energy_input_t input = level;
    input.roll_deg = -30.0F;
    energy_state_t law = engaged(&input);
    const energy_command_t command = settle(&law, &input, 0.1);
    // g / V tan(30) sin(30) over the rate of a full command
    assert_close(command.elevator, 9.80665 / 28.29 * 0.57735 * 0.5 / 2.1, 1e-3);
}

static void a_gust_pulls_no_more_than_the_load_limit(void** state)
{
    (void)state;
    energy_input_t input = level;
    energy_state_t law = engaged(&input);
    input.vvi_ft_min = -4000.0F;
    const energy_command_t command = settle(&law, &input, 3.0);
    assert_close(command.elevator, 9.80665 / 28.29 / 2.1, 1e-3);
}

static void new_targets_move_nothing_at_once(void** state)
{
    (void)state;
    energy_state_t law = engaged(&level);
    energy_command_t before = settle(&law, &level, 1.0);
    for (int i = 0; i < 300; i++)
    {
        const energy_target_t other = {.altitude_ft = i % 9 < 5 ? 4000.0F : 0.0F,
                                       .speed_kt = i % 7 < 3 ? 90.0F : 40.0F};
        const energy_command_t after = energy_update(&law, &gains, &other, &level, dt_s);
        assert_true(fabsf(after.elevator - before.elevator) < 0.1F);
        assert_true(fabsf(after.throttle - before.throttle) <= 0.0201F);
        before = after;
    }
}

static void frozen_the_integrals_stay(void** state)
{
    (void)state;
    energy_input_t input = level;
    energy_state_t law = engaged(&input);
    input.frozen = true;
    input.altitude_ft = 950.0F;
    input.speed_kt = 10.0F;
    (void)settle(&law, &input, 5.0);
    assert_close(law.pitch_trim_deg, 3.0, 1e-5);
    assert_close(law.throttle_trim, 0.4, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_target_it_keeps_what_it_found),
        cmocka_unit_test(too_low_it_pulls_and_gives_throttle_and_too_high_the_opposite),
        cmocka_unit_test(too_slow_is_the_throttles_business),
        cmocka_unit_test(the_climb_keeps_its_limits),
        cmocka_unit_test(without_power_in_hand_the_speed_comes_before_the_climb_and_it_is_told),
        cmocka_unit_test(a_turn_is_pulled_for),
        cmocka_unit_test(a_gust_pulls_no_more_than_the_load_limit),
        cmocka_unit_test(new_targets_move_nothing_at_once),
        cmocka_unit_test(frozen_the_integrals_stay),
    };
    return cmocka_run_group_tests_name("control.energy", tests, NULL, NULL);
}
