#include "support/cmocka_all.h"

#include "estimation/gravity.h"

static void at_rest_down_is_against_the_felt_force(void** state)
{
    (void)state;
    const gravity_input_t input = {.force_m_s2 = {.x = 4.903F, .z = -8.493F}}; // nose 30 degrees up
    const gravity_t gravity = gravity_felt(&input);
    assert_close(gravity.down.x, -0.5, 0.001);
    assert_close(gravity.down.z, 0.866, 0.001);
    assert_close(gravity.trust, 1.0, 0.01);
}

// Bank 30 degrees at 28.3 m/s: g tan(30) / V = 0.2 rad/s of turn, shared by q and r; felt is g / cos(30) along z.
static void a_coordinated_turn_does_not_look_like_level_flight(void** state)
{
    (void)state;
    const gravity_input_t input = {
        .force_m_s2 = {.z = -11.324F},
        .rate_rad_s = {.y = 0.1F, .z = 0.17321F},
        .airspeed_m_s = 28.309F,
    };
    const gravity_t gravity = gravity_felt(&input);
    assert_close(gravity.down.y, 0.5, 0.001);
    assert_close(gravity.down.z, 0.866, 0.001);
    assert_close(gravity.trust, 1.0, 0.01);
}

static void gaining_speed_does_not_look_like_a_climb(void** state)
{
    (void)state;
    const gravity_input_t input = {
        .force_m_s2 = {.x = 2.0F, .z = -9.80665F}, .airspeed_m_s = 20.0F, .acceleration_m_s2 = 2.0F};
    assert_close(gravity_felt(&input).down.x, 0.0, 0.001);
}

static void the_further_from_g_the_less_it_is_trusted(void** state)
{
    (void)state;
    float last = 1.1F;
    for (int percent = 100; percent <= 129; percent += 5)
    {
        const gravity_input_t input = {.force_m_s2 = {.z = -9.80665F * (float)percent / 100.0F}};
        const float trust = gravity_felt(&input).trust;
        assert_true(trust < last);
        assert_true(trust > 0.0F);
        last = trust;
    }
}

static void a_hard_landing_and_free_fall_say_nothing_about_down(void** state)
{
    (void)state;
    const gravity_input_t landing = {.force_m_s2 = {.x = -20.0F, .z = -40.0F}};
    const gravity_input_t falling = {.force_m_s2 = {.x = 0.0F}};
    assert_close(gravity_felt(&landing).trust, 0.0, 0.0);
    assert_close(gravity_felt(&falling).trust, 0.0, 0.0);
    assert_close(vector_length(gravity_felt(&falling).down), 1.0, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_rest_down_is_against_the_felt_force),
        cmocka_unit_test(a_coordinated_turn_does_not_look_like_level_flight),
        cmocka_unit_test(gaining_speed_does_not_look_like_a_climb),
        cmocka_unit_test(the_further_from_g_the_less_it_is_trusted),
        cmocka_unit_test(a_hard_landing_and_free_fall_say_nothing_about_down),
    };
    return cmocka_run_group_tests_name("estimation.gravity", tests, NULL, NULL);
}
