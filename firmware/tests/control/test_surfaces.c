#include "support/cmocka_all.h"

#include "control/surfaces.h"

static void surfaces_inside_of_their_limits_stay(void** state)
{
    (void)state;
    const surfaces_t some = {.elevator = -1.0F, .aileron = 1.0F, .rudder = 0.25F, .throttle = 0.0F};
    const surfaces_t same = surfaces_in_limits(&some);
    assert_memory_equal(&same, &some, sizeof some);
}

static void each_surface_is_limited_to_its_own_range(void** state)
{
    (void)state;
    const surfaces_t low = {.elevator = -2.0F, .aileron = -INFINITY, .rudder = -1.5F, .throttle = -0.1F};
    const surfaces_t lowest = {.elevator = -1.0F, .aileron = -1.0F, .rudder = -1.0F, .throttle = 0.0F};
    const surfaces_t high = {.elevator = 2.0F, .aileron = INFINITY, .rudder = 1.5F, .throttle = 1.1F};
    const surfaces_t highest = {.elevator = 1.0F, .aileron = 1.0F, .rudder = 1.0F, .throttle = 1.0F};
    surfaces_t limited = surfaces_in_limits(&low);
    assert_memory_equal(&limited, &lowest, sizeof limited);
    limited = surfaces_in_limits(&high);
    assert_memory_equal(&limited, &highest, sizeof limited);
}

static void a_value_that_is_no_number_counts_as_0(void** state)
{
    (void)state;
    const surfaces_t unknown = {.elevator = NAN, .aileron = NAN, .rudder = NAN, .throttle = NAN};
    const surfaces_t neutral = {.elevator = 0.0F, .aileron = 0.0F, .rudder = 0.0F, .throttle = 0.0F};
    const surfaces_t limited = surfaces_in_limits(&unknown);
    assert_memory_equal(&limited, &neutral, sizeof limited);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surfaces_inside_of_their_limits_stay),
        cmocka_unit_test(each_surface_is_limited_to_its_own_range),
        cmocka_unit_test(a_value_that_is_no_number_counts_as_0),
    };
    return cmocka_run_group_tests_name("control.surfaces", tests, NULL, NULL);
}
