#include "support/cmocka_all.h"

#include <math.h>

#include "common/limit.h"

static void a_value_inside_of_its_limits_is_untouched(void** state)
{
    (void)state;
    assert_close(limit_to(0.25F, -1.0F, 1.0F), 0.25F, 0.0);
}

static void a_value_outside_stops_at_the_limit(void** state)
{
    (void)state;
    assert_close(limit_to(1.5F, -1.0F, 1.0F), 1.0F, 0.0);
    assert_close(limit_to(-1.5F, -1.0F, 1.0F), -1.0F, 0.0);
    assert_close(limit_to(INFINITY, -1.0F, 1.0F), 1.0F, 0.0);
    assert_close(limit_to(-INFINITY, 0.0F, 1.0F), 0.0F, 0.0);
}

static void what_is_no_number_counts_as_zero(void** state)
{
    (void)state;
    assert_close(limit_to(NAN, -1.0F, 1.0F), 0.0F, 0.0);
    assert_close(limit_to(NAN, 5.0F, 200.0F), 5.0F, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_value_inside_of_its_limits_is_untouched),
        cmocka_unit_test(a_value_outside_stops_at_the_limit),
        cmocka_unit_test(what_is_no_number_counts_as_zero),
    };
    return cmocka_run_group_tests_name("common.limit", tests, NULL, NULL);
}
