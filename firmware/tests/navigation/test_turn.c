#include "support/cmocka_all.h"

#include "navigation/turn.h"

static const float airspeed_m_s = 28.0F;
static const double radius_m = 138.5; ///< 28^2 / (g tan 30)

static turn_t turn(float from_deg, float to_deg, float wind_east_m_s)
{
    wind_t wind;
    wind_init(&wind);
    wind.east_m_s = wind_east_m_s;
    return turn_between(from_deg, to_deg, &wind, airspeed_m_s, 30.0F, 0.0F);
}

static void in_calm_air_it_is_the_tangent_of_half_the_angle(void** state)
{
    (void)state;
    assert_close(turn(0.0F, 90.0F, 0.0F).lead_m, radius_m, 1.0);
    assert_close(turn(0.0F, -60.0F, 0.0F).lead_m, radius_m * 0.57735, 1.0);
    assert_close(turn(350.0F, 20.0F, 0.0F).lead_m, radius_m * 0.26795, 1.0);
    assert_close(turn(0.0F, 90.0F, 0.0F).radius_m, radius_m, 1.0);
}

static void straight_on_needs_no_lead(void** state)
{
    (void)state;
    assert_close(turn(100.0F, 101.0F, 0.0F).lead_m, 0.0, 0.0);
}

static void turning_with_the_wind_begins_earlier_than_against_it(void** state)
{
    (void)state;
    const float with_it_m = turn(0.0F, 90.0F, 10.0F).lead_m;
    const float against_it_m = turn(0.0F, 270.0F, 10.0F).lead_m;
    const float calm_m = turn(0.0F, 90.0F, 0.0F).lead_m;
    // into the wind the nose has already turned there, away from it it has to come round further
    assert_true(with_it_m > calm_m);
    assert_true(against_it_m < calm_m);
}

static void the_lag_of_the_bank_is_flown_before_the_turn(void** state)
{
    (void)state;
    wind_t wind;
    wind_init(&wind);
    const turn_t slow = turn_between(0.0F, 90.0F, &wind, airspeed_m_s, 30.0F, 1.0F);
    assert_close(slow.lead_m, radius_m + 28.0, 1.0);
}

static void a_sharp_turn_has_a_lead_of_about_a_radius_and_says_so(void** state)
{
    (void)state;
    assert_false(turn(0.0F, 110.0F, 0.0F).is_sharp);
    const turn_t sharp = turn(0.0F, 160.0F, 0.0F);
    assert_true(sharp.is_sharp);
    assert_close(sharp.lead_m, radius_m, 1.0);
    assert_close(turn(0.0F, 180.0F, 3.0F).lead_m, radius_m, 3.0);
    assert_true(isfinite(turn(0.0F, -180.0F, -27.0F).lead_m));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_calm_air_it_is_the_tangent_of_half_the_angle),
        cmocka_unit_test(straight_on_needs_no_lead),
        cmocka_unit_test(turning_with_the_wind_begins_earlier_than_against_it),
        cmocka_unit_test(the_lag_of_the_bank_is_flown_before_the_turn),
        cmocka_unit_test(a_sharp_turn_has_a_lead_of_about_a_radius_and_says_so),
    };
    return cmocka_run_group_tests_name("navigation.turn", tests, NULL, NULL);
}
