// Made by protocol/generator (emit_c.py). Do not edit: change protocol/definition and run `make generate`.
#include "parameters_gen.h"

const parameter_definition_t parameter_definitions[PARAMETER_COUNT] = {
    {"k_int_altura", 76u, false, 0.0f, 99.99f, 0.001f, 0.06f},
    {"k_altura", 75u, false, 0.0f, 99.99f, 0.001f, 0.06f},
    {"k_VVI", 74u, false, 0.0f, 99.99f, 0.01f, 0.1f},
    {"k_pitch", 73u, false, 0.0f, 99.99f, 0.1f, 2.0f},
    {"k_heading", 72u, false, 0.0f, 99.99f, 0.01f, 0.8f},
    {"k_roll", 71u, false, 0.0f, 99.99f, 0.1f, 2.0f},
    {"k_div_velocidad", 70u, true, 10.0f, 10000.0f, 10.0f, 700.0f},
    {"k_div_P_init", 64u, false, 0.1f, 99.99f, 0.01f, 0.5f},
    {"k_div_P_speed", 65u, false, 10.0f, 99.99f, 1.0f, 30.0f},
    {"k_div_Q_init", 66u, false, 0.1f, 99.99f, 0.1f, 0.2f},
    {"k_div_Q_speed", 67u, false, 10.0f, 99.99f, 1.0f, 40.0f},
    {"k_div_R_init", 68u, false, 0.1f, 99.99f, 0.01f, 0.1f},
    {"k_div_R_speed", 69u, false, 10.0f, 99.99f, 1.0f, 35.0f},
    {"k_int_pitch", 63u, false, 0.0f, 99.99f, 0.01f, 0.6f},
    {"k_elev", 60u, false, 0.0f, 99.99f, 0.1f, 1.0f},
    {"k_airln", 61u, false, 0.0f, 99.99f, 0.01f, 0.6f},
    {"k_rudder", 62u, false, 0.0f, 99.99f, 0.1f, 1.0f},
};
