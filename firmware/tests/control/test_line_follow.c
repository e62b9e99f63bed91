#include "support/cmocka_all.h"

#include "control/line_follow.h"

static const line_follow_gains_t gains = {
    .bank_limit_deg = 30.0F,
    .approach_time_s = 3.0F,
    .k_course_per_s = 0.9F,
    .k_bank = 3.0F,
    .k_int_bank_per_s = 0.5F,
};
static const float dt_s = 0.02F;

/// Bank that is asked for once the limit of its rate has been waited out.
static float settled_bank_deg(const line_follow_target_t* target, const line_follow_input_t* input)
{
    line_follow_state_t law;
    line_follow_engage(&law, input->roll_deg);
    for (int i = 0; i < 200; i++)
    {
        (void)line_follow_update(&law, &gains, target, input, dt_s);
    }
    return law.roll_d_deg;
}

static const line_follow_input_t east = {.track_deg = 90.0F, .ground_speed_m_s = 28.0F, .frozen = true};

static void on_the_line_it_asks_for_nothing(void** state)
{
    (void)state;
    const line_follow_target_t target = {.course_deg = 90.0F};
    assert_close(settled_bank_deg(&target, &east), 0.0, 1e-4);
}

static void right_of_the_line_it_banks_left(void** state)
{
    (void)state;
    line_follow_target_t target = {.course_deg = 90.0F, .right_m = 10.0F};
    assert_true(settled_bank_deg(&target, &east) < -5.0F);
    target.right_m = -10.0F;
    assert_true(settled_bank_deg(&target, &east) > 5.0F);
}

static void a_track_right_of_the_course_banks_left_through_north_too(void** state)
{
    (void)state;
    const line_follow_target_t target = {.course_deg = 359.0F};
    line_follow_input_t input = east;
    input.track_deg = 4.0F;
    assert_true(settled_bank_deg(&target, &input) < -5.0F);
    input.track_deg = 354.0F;
    assert_true(settled_bank_deg(&target, &input) > 5.0F);
}

static void the_bank_never_passes_its_limit(void** state)
{
    (void)state;
    const line_follow_target_t target = {.course_deg = 90.0F, .right_m = 5000.0F};
    assert_close(settled_bank_deg(&target, &east), -30.0, 1e-4);
}

static void a_circle_is_banked_for(void** state)
{
    (void)state;
    const line_follow_target_t target = {.course_deg = 90.0F, .curvature_per_m = 1.0F / 200.0F};
    // V^2 / (g r)
    assert_close(settled_bank_deg(&target, &east), 21.8, 0.1);
}

static void a_new_line_moves_the_aileron_in_small_steps(void** state)
{
    (void)state;
    line_follow_state_t law;
    line_follow_engage(&law, 0.0F);
    float before = 0.0F;
    for (int i = 0; i < 100; i++)
    {
        const line_follow_target_t target = {.course_deg = 90.0F, .right_m = i % 7 < 3 ? 800.0F : -800.0F};
        const float aileron = line_follow_update(&law, &gains, &target, &east, dt_s);
        assert_true(fabsf(aileron - before) < 0.1F);
        before = aileron;
    }
}

static void a_lopsided_aircraft_is_held_level_by_the_integral(void** state)
{
    (void)state;
    const line_follow_target_t target = {.course_deg = 90.0F};
    line_follow_input_t input = east;
    input.roll_deg = 1.0F;
    input.frozen = false;
    line_follow_state_t law;
    line_follow_engage(&law, 0.0F);
    const float first = line_follow_update(&law, &gains, &target, &input, dt_s);
    float last = first;
    for (int i = 0; i < 200; i++)
    {
        last = line_follow_update(&law, &gains, &target, &input, dt_s);
    }
    assert_true(last < first - 0.05F);
    input.frozen = true;
    const float held = law.aileron_integral;
    (void)line_follow_update(&law, &gains, &target, &input, dt_s);
    assert_close(law.aileron_integral, held, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_the_line_it_asks_for_nothing),
        cmocka_unit_test(right_of_the_line_it_banks_left),
        cmocka_unit_test(a_track_right_of_the_course_banks_left_through_north_too),
        cmocka_unit_test(the_bank_never_passes_its_limit),
        cmocka_unit_test(a_circle_is_banked_for),
        cmocka_unit_test(a_new_line_moves_the_aileron_in_small_steps),
        cmocka_unit_test(a_lopsided_aircraft_is_held_level_by_the_integral),
    };
    return cmocka_run_group_tests_name("control.line_follow", tests, NULL, NULL);
}
