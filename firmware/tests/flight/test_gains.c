#include "support/cmocka_all.h"

#include "flight/gains.h"

static void every_parameter_reaches_the_gain_of_its_name(void** state)
{
    (void)state;
    parameters_t parameters;
    for (size_t i = 0; i < parameters_count; i++)
    {
        parameters.values[i] = (float)i + 1.0F;
    }
    const control_loop_gains_t gains = gains_of(&parameters);
    const struct
    {
        const char* name;
        float value;
    } pairs[] = {
        {"k_elev", gains.fly_by_wire.k_elev},
        {"k_airln", gains.fly_by_wire.k_airln},
        {"k_rudder", gains.fly_by_wire.k_rudder},
        {"k_int_pitch", gains.fly_by_wire.k_int_pitch_per_s},
        {"k_div_P_init", gains.fly_by_wire.k_div_p_init},
        {"k_div_P_speed", gains.fly_by_wire.k_div_p_speed_kt},
        {"k_div_Q_init", gains.fly_by_wire.k_div_q_init},
        {"k_div_Q_speed", gains.fly_by_wire.k_div_q_speed_kt},
        {"k_div_R_init", gains.fly_by_wire.k_div_r_init},
        {"k_div_R_speed", gains.fly_by_wire.k_div_r_speed_kt},
        {"k_div_velocidad", gains.autopilot.k_div_speed_kt_s},
        {"k_roll", gains.autopilot.k_roll},
        {"k_heading", gains.autopilot.k_heading},
        {"k_pitch", gains.autopilot.k_pitch},
        {"k_VVI", gains.autopilot.k_vvi_ft_per_ft_min},
        {"k_altura", gains.autopilot.k_altitude},
        {"k_int_altura", gains.autopilot.k_int_altitude_per_s},
    };
    assert_int_equal(sizeof pairs / sizeof pairs[0], parameters_count);
    for (size_t i = 0; i < parameters_count; i++)
    {
        assert_close(pairs[i].value, parameters_index_of_name(pairs[i].name) + 1, 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_parameter_reaches_the_gain_of_its_name),
    };
    return cmocka_run_group_tests_name("flight.gains", tests, NULL, NULL);
}
