#include "support/cmocka_all.h"

#include <math.h>

#include "control/transition.h"

static const surfaces_t before = {.elevator = -0.2F, .aileron = 0.4F, .rudder = 0.1F, .throttle = 0.7F};
static const surfaces_t wanted = {.elevator = 0.3F, .aileron = -0.1F, .rudder = 0.0F, .throttle = 0.2F};

static void without_a_change_the_law_goes_straight_through(void** state)
{
    (void)state;
    transition_t transition;
    transition_init(&transition);
    const surfaces_t out = transition_update(&transition, &wanted, 0.02F);
    assert_memory_equal(&out, &wanted, sizeof out);
}

static void the_first_surfaces_after_a_change_are_the_last_before_it(void** state)
{
    (void)state;
    transition_t transition;
    transition_begin(&transition, &before, &wanted);
    const surfaces_t out = transition_update(&transition, &wanted, 0.02F);
    assert_close(out.elevator, before.elevator, 1e-6);
    assert_close(out.aileron, before.aileron, 1e-6);
    assert_close(out.rudder, before.rudder, 1e-6);
    assert_close(out.throttle, before.throttle, 1e-6);
}

static void the_new_law_takes_over_within_seconds_and_without_a_jump(void** state)
{
    (void)state;
    transition_t transition;
    transition_begin(&transition, &before, &wanted);
    surfaces_t last = before;
    for (int i = 0; i < 200; i++)
    {
        const surfaces_t out = transition_update(&transition, &wanted, 0.02F);
        assert_true(fabsf(out.elevator - last.elevator) < 0.02F);
        assert_true(fabsf(out.throttle - last.throttle) < 0.02F);
        last = out;
    }
    assert_close(last.elevator, wanted.elevator, 0.01);
    assert_close(last.aileron, wanted.aileron, 0.01);
    assert_close(last.throttle, wanted.throttle, 0.01);
}

static void what_is_added_never_leaves_the_surfaces_limits(void** state)
{
    (void)state;
    transition_t transition;
    const surfaces_t low = {.elevator = -1.0F, .aileron = -1.0F, .rudder = -1.0F, .throttle = 0.0F};
    const surfaces_t high = {.elevator = 1.0F, .aileron = 1.0F, .rudder = 1.0F, .throttle = 1.0F};
    transition_begin(&transition, &high, &low);
    // the law swings to the other stop while the offset is still there
    const surfaces_t out = transition_update(&transition, &high, 0.02F);
    assert_memory_equal(&out, &high, sizeof out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_change_the_law_goes_straight_through),
        cmocka_unit_test(the_first_surfaces_after_a_change_are_the_last_before_it),
        cmocka_unit_test(the_new_law_takes_over_within_seconds_and_without_a_jump),
        cmocka_unit_test(what_is_added_never_leaves_the_surfaces_limits),
    };
    return cmocka_run_group_tests_name("control.transition", tests, NULL, NULL);
}
