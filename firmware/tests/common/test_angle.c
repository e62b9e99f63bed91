#include "support/cmocka_all.h"

#include <math.h>

#include "common/angle.h"

static void a_direction_is_wrapped_to_the_half_circle_around_zero(void** state)
{
    (void)state;
    assert_close(angle_wrap_180(190.0F), -170.0F, 1e-4);
    assert_close(angle_wrap_180(-190.0F), 170.0F, 1e-4);
    assert_close(angle_wrap_180(180.0F), -180.0F, 1e-4);
    assert_close(angle_wrap_180(725.0F), 5.0F, 1e-4);
}

static void a_compass_direction_is_never_360(void** state)
{
    (void)state;
    assert_close(angle_wrap_360(-10.0F), 350.0F, 1e-4);
    assert_close(angle_wrap_360(360.0F), 0.0F, 1e-4);
    assert_true(angle_wrap_360(-1e-9F) < 360.0F);
    assert_true(angle_wrap_360(-1e-9F) >= 0.0F);
}

static void what_is_no_number_stays_none(void** state)
{
    (void)state;
    assert_true(isnan(angle_wrap_180(NAN)));
    assert_true(isnan(angle_wrap_360(INFINITY)));
}

static void degrees_and_radians_undo_each_other(void** state)
{
    (void)state;
    assert_close(angle_to_rad(180.0F), 3.14159265, 1e-6);
    assert_close(angle_to_deg(angle_to_rad(-77.5F)), -77.5, 1e-4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_direction_is_wrapped_to_the_half_circle_around_zero),
        cmocka_unit_test(a_compass_direction_is_never_360),
        cmocka_unit_test(what_is_no_number_stays_none),
        cmocka_unit_test(degrees_and_radians_undo_each_other),
    };
    return cmocka_run_group_tests_name("common.angle", tests, NULL, NULL);
}
