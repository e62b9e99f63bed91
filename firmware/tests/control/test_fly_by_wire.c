#include "support/cmocka_all.h"

#include <math.h>

#include "control/fly_by_wire.h"

// the default gains of the protocol
static const fly_by_wire_gains_t gains = {
    .k_elev = 1.0F,
    .k_int_pitch_per_s = 0.6F,
    .k_airln = 0.6F,
    .k_rudder = 1.0F,
    .k_div_p_init = 0.5F,
    .k_div_p_speed_kt = 30.0F,
    .k_div_q_init = 0.2F,
    .k_div_q_speed_kt = 40.0F,
    .k_div_r_init = 0.1F,
    .k_div_r_speed_kt = 35.0F,
};
static const float dt_s = 0.02F;

static surfaces_t run(fly_by_wire_state_t* state, control_command_t command, fly_by_wire_input_t input, int steps)
{
    surfaces_t surfaces = {0};
    for (int i = 0; i < steps; i++)
    {
        surfaces = fly_by_wire_update(state, &gains, &command, &input, dt_s);
    }
    return surfaces;
}

static void nothing_asked_and_nothing_moving_leaves_the_surfaces_alone(void** state)
{
    (void)state;
    fly_by_wire_state_t law = {0};
    const surfaces_t surfaces = run(&law, (control_command_t){0}, (fly_by_wire_input_t){.speed_kt = 55.0F}, 500);
    assert_close(surfaces.elevator, 0.0F, 0.0);
    assert_close(surfaces.aileron, 0.0F, 0.0);
    assert_close(surfaces.rudder, 0.0F, 0.0);
    assert_close(surfaces.throttle, 0.0F, 0.0);
}

static void the_stick_is_twofold_in_pitch_and_threefold_in_roll(void** state)
{
    (void)state;
    const control_command_t command = fly_by_wire_command_of_stick(0.1F, -0.2F, 0.3F, 0.4F);
    assert_close(command.elevator, 0.2, 1e-6);
    assert_close(command.aileron, -0.6, 1e-6);
    assert_close(command.rudder, 0.3F, 0.0);
    assert_close(command.throttle, 0.4F, 0.0);
}

static void each_rate_is_damped_by_what_the_specification_says(void** state)
{
    (void)state;
    fly_by_wire_state_t law = {0};
    const fly_by_wire_input_t input = {.p_rad_s = 0.3F, .q_rad_s = 0.2F, .r_rad_s = 0.1F, .speed_kt = 60.0F};
    const control_command_t command = {.elevator = 0.15F, .aileron = 0.25F, .rudder = 0.05F, .throttle = 0.5F};
    const surfaces_t surfaces = run(&law, command, input, 1);
    // by hand: div_P = 0.5 + 2^2, div_Q = 0.2 + 1.5^2, div_R = 0.1 + (60/35)^2
    assert_close(surfaces.elevator, 0.15 - 0.2 / 2.45, 1e-6);
    assert_close(surfaces.aileron, 0.6 * (0.25 - 0.3 / 4.5), 1e-6);
    assert_close(surfaces.rudder, 0.05 - 0.1 / (0.1 + 3600.0 / 1225.0), 1e-6);
    assert_close(surfaces.throttle, 0.5F, 0.0);
}

static void a_rate_is_opposed_on_every_axis(void** state)
{
    (void)state;
    fly_by_wire_state_t law = {0};
    const fly_by_wire_input_t input = {.p_rad_s = 1.0F, .q_rad_s = 1.0F, .r_rad_s = 1.0F, .speed_kt = 50.0F};
    const surfaces_t surfaces = run(&law, (control_command_t){0}, input, 1);
    assert_true(surfaces.aileron < 0.0F);
    assert_true(surfaces.elevator < 0.0F);
    assert_true(surfaces.rudder < 0.0F);
}

static void the_trim_integrates_the_error_and_stops_at_full_deflection(void** state)
{
    (void)state;
    fly_by_wire_state_t law = {0};
    const fly_by_wire_input_t input = {.speed_kt = 55.0F, .autotrim = true};
    const control_command_t command = {.elevator = 0.1F};
    (void)run(&law, command, input, 50);
    assert_close(law.trim, 0.6 * 0.1 * 1.0, 1e-4); // k_int_pitch * error * 1 s
    const surfaces_t surfaces = run(&law, command, input, 100000);
    assert_close(law.trim, 1.0F, 0.0);
    assert_close(surfaces.elevator, 1.0F, 0.0);
    // and comes back at once when the error turns, without unwinding anything beyond the limit
    (void)run(&law, (control_command_t){.elevator = -0.1F}, input, 1);
    assert_true(law.trim < 1.0F);
}

static void without_autotrim_there_is_no_trim(void** state)
{
    (void)state;
    fly_by_wire_state_t law = {.trim = 0.4F};
    const surfaces_t surfaces =
        run(&law, (control_command_t){.elevator = 0.1F}, (fly_by_wire_input_t){.speed_kt = 55.0F}, 10);
    assert_close(law.trim, 0.0F, 0.0);
    assert_close(surfaces.elevator, 0.1, 1e-6);
}

static void a_frozen_trim_keeps_its_value(void** state)
{
    (void)state;
    fly_by_wire_state_t law = {.trim = 0.2F};
    const fly_by_wire_input_t input = {.speed_kt = 5.0F, .autotrim = true, .frozen = true};
    (void)run(&law, (control_command_t){.elevator = 1.0F}, input, 100);
    assert_close(law.trim, 0.2F, 0.0);
}

static void surfaces_stop_at_their_limits(void** state)
{
    (void)state;
    fly_by_wire_state_t law = {0};
    const fly_by_wire_input_t input = {.speed_kt = 55.0F};
    const surfaces_t up = run(&law, (control_command_t){9.0F, 9.0F, 9.0F, 9.0F}, input, 1);
    const surfaces_t down = run(&law, (control_command_t){-9.0F, -9.0F, -9.0F, -9.0F}, input, 1);
    assert_close(up.elevator, 1.0F, 0.0);
    assert_close(up.aileron, 1.0F, 0.0);
    assert_close(up.rudder, 1.0F, 0.0);
    assert_close(up.throttle, 1.0F, 0.0);
    assert_close(down.elevator, -1.0F, 0.0);
    assert_close(down.aileron, -1.0F, 0.0);
    assert_close(down.rudder, -1.0F, 0.0);
    assert_close(down.throttle, 0.0F, 0.0);
}

static void holding_the_elevator_makes_the_next_step_begin_there(void** state)
{
    (void)state;
    fly_by_wire_state_t law = {0};
    const fly_by_wire_input_t input = {.q_rad_s = 0.05F, .speed_kt = 50.0F, .autotrim = true};
    const control_command_t command = {.elevator = 0.1F};
    fly_by_wire_hold_elevator(&law, &gains, &command, &input, -0.3F);
    const surfaces_t surfaces = fly_by_wire_update(&law, &gains, &command, &input, 0.0F);
    assert_close(surfaces.elevator, -0.3, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_asked_and_nothing_moving_leaves_the_surfaces_alone),
        cmocka_unit_test(the_stick_is_twofold_in_pitch_and_threefold_in_roll),
        cmocka_unit_test(each_rate_is_damped_by_what_the_specification_says),
        cmocka_unit_test(a_rate_is_opposed_on_every_axis),
        cmocka_unit_test(the_trim_integrates_the_error_and_stops_at_full_deflection),
        cmocka_unit_test(without_autotrim_there_is_no_trim),
        cmocka_unit_test(a_frozen_trim_keeps_its_value),
        cmocka_unit_test(surfaces_stop_at_their_limits),
        cmocka_unit_test(holding_the_elevator_makes_the_next_step_begin_there),
    };
    return cmocka_run_group_tests_name("control.fly_by_wire", tests, NULL, NULL);
}
