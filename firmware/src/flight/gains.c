#include "flight/gains.h"

control_loop_gains_t gains_of(const parameters_t* parameters)
{
    const float* const values = parameters->values;
    return (control_loop_gains_t){
        .fly_by_wire =
            {
                .k_elev = values[PARAMETER_K_ELEV],
                .k_int_pitch_per_s = values[PARAMETER_K_INT_PITCH],
                .k_airln = values[PARAMETER_K_AIRLN],
                .k_rudder = values[PARAMETER_K_RUDDER],
                .k_div_p_init = values[PARAMETER_K_DIV_P_INIT],
                .k_div_p_speed_kt = values[PARAMETER_K_DIV_P_SPEED],
                .k_div_q_init = values[PARAMETER_K_DIV_Q_INIT],
                .k_div_q_speed_kt = values[PARAMETER_K_DIV_Q_SPEED],
                .k_div_r_init = values[PARAMETER_K_DIV_R_INIT],
                .k_div_r_speed_kt = values[PARAMETER_K_DIV_R_SPEED],
            },
        .autopilot =
            {
                .k_altitude = values[PARAMETER_K_ALTURA],
                .k_int_altitude_per_s = values[PARAMETER_K_INT_ALTURA],
                .k_vvi_ft_per_ft_min = values[PARAMETER_K_VVI],
                .k_pitch = values[PARAMETER_K_PITCH],
                .k_heading = values[PARAMETER_K_HEADING],
                .k_roll = values[PARAMETER_K_ROLL],
                .k_div_speed_kt_s = values[PARAMETER_K_DIV_VELOCIDAD],
            },
        .line = line_gains_default(),
        .law = guidance_law_bearing,
    };
}
