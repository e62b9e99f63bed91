#include "support/cmocka_all.h"

#include "navigation/leg.h"

static const position_t begin = {27.9, -15.4};
static const position_t end = {27.9, -15.3}; // 9826 m to the east

static void a_place_is_told_along_and_across(void** state)
{
    (void)state;
    const leg_t leg = leg_between(&begin, &end, 0.0F);
    assert_close(leg.course_deg, 90.0, 1e-3);
    assert_close(leg.length_m, 9827.0, 3.0);
    const position_t south = {27.899, -15.35};
    const leg_place_t place = leg_place(&leg, &south);
    assert_close(place.remaining_m, leg.length_m / 2.0F, 1.0);
    assert_close(place.right_m, 111.2, 0.2);
}

static void beyond_the_end_nothing_remains(void** state)
{
    (void)state;
    const leg_t leg = leg_between(&begin, &end, 0.0F);
    const position_t beyond = {27.901, -15.299};
    const leg_place_t place = leg_place(&leg, &beyond);
    assert_close(place.remaining_m, -98.3, 0.2);
    assert_close(place.right_m, -111.2, 0.2);
}

static void a_leg_without_length_takes_the_given_course(void** state)
{
    (void)state;
    const leg_t leg = leg_between(&end, &end, -45.0F);
    assert_close(leg.course_deg, 315.0, 1e-3);
    assert_close(leg.length_m, 0.0, 0.0);
    const position_t ahead = {27.901, -15.3};
    assert_close(leg_place(&leg, &ahead).remaining_m, -78.6, 0.2);
}

static void a_leg_may_cross_the_date_line(void** state)
{
    (void)state;
    const position_t west = {0.0, 179.99};
    const position_t east = {0.0, -179.99};
    const leg_t leg = leg_between(&west, &east, 0.0F);
    assert_close(leg.course_deg, 90.0, 1e-3);
    assert_close(leg.length_m, 2223.9, 1.0);
    assert_close(leg_offset_m(&east, &west).east_m, -2223.9, 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_is_told_along_and_across),
        cmocka_unit_test(beyond_the_end_nothing_remains),
        cmocka_unit_test(a_leg_without_length_takes_the_given_course),
        cmocka_unit_test(a_leg_may_cross_the_date_line),
    };
    return cmocka_run_group_tests_name("navigation.leg", tests, NULL, NULL);
}
