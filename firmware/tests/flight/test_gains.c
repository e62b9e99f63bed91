#include "support/cmocka_all.h"

#include <string.h>

#include "flight/gains.h"

static void every_parameter_reaches_one_gain_of_its_own(void** state)
{
    (void)state;
    parameters_t parameters;
    for (size_t i = 0; i < parameters_count; i++)
    {
        parameters.values[i] = (float)i + 1.0F;
    }
    const control_loop_gains_t gains = gains_of(&parameters);
    float values[parameters_count];
    assert_int_equal(sizeof gains, sizeof values);
    memcpy(values, &gains, sizeof values);
    int sum = 0;
    int squares = 0;
    for (size_t i = 0; i < parameters_count; i++)
    {
        sum += (int)values[i];
        squares += (int)(values[i] * values[i]);
    }
    // 1..17 once each: no other 17 numbers of that range have both sums by a single wrong wire
    assert_int_equal(sum, 153);
    assert_int_equal(squares, 1785);
}

static void the_gains_have_the_names_of_their_parameters(void** state)
{
    (void)state;
    parameters_t parameters;
    parameters_init(&parameters);
    parameters.values[PARAMETER_K_DIV_R_SPEED] = 36.5F;
    parameters.values[PARAMETER_K_VVI] = 0.15F;
    parameters.values[PARAMETER_K_INT_PITCH] = 0.7F;
    const control_loop_gains_t gains = gains_of(&parameters);
    assert_close(gains.fly_by_wire.k_div_r_speed_kt, 36.5, 0.0);
    assert_close(gains.autopilot.k_vvi_ft_per_ft_min, 0.15, 1e-7);
    assert_close(gains.fly_by_wire.k_int_pitch_per_s, 0.7, 1e-7);
    assert_close(gains.autopilot.k_int_altitude_per_s, 0.06, 1e-7);
    assert_close(gains.fly_by_wire.k_airln, 0.6, 1e-7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_parameter_reaches_one_gain_of_its_own),
        cmocka_unit_test(the_gains_have_the_names_of_their_parameters),
    };
    return cmocka_run_group_tests_name("flight.gains", tests, NULL, NULL);
}
