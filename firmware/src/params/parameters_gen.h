// Made by protocol/generator (emit_c.py). Do not edit: change protocol/definition and run `make generate`.
#ifndef PARAMETERS_GEN_H
#define PARAMETERS_GEN_H

#include <stdbool.h>
#include <stdint.h>

#define PARAMETER_COUNT 17u

/// Place of a parameter in the table and in the message autopilot_parameters.
typedef enum
{
    PARAMETER_K_INT_ALTURA = 0,
    PARAMETER_K_ALTURA = 1,
    PARAMETER_K_VVI = 2,
    PARAMETER_K_PITCH = 3,
    PARAMETER_K_HEADING = 4,
    PARAMETER_K_ROLL = 5,
    PARAMETER_K_DIV_VELOCIDAD = 6,
    PARAMETER_K_DIV_P_INIT = 7,
    PARAMETER_K_DIV_P_SPEED = 8,
    PARAMETER_K_DIV_Q_INIT = 9,
    PARAMETER_K_DIV_Q_SPEED = 10,
    PARAMETER_K_DIV_R_INIT = 11,
    PARAMETER_K_DIV_R_SPEED = 12,
    PARAMETER_K_INT_PITCH = 13,
    PARAMETER_K_ELEV = 14,
    PARAMETER_K_AIRLN = 15,
    PARAMETER_K_RUDDER = 16,
} parameter_index_t;

/// What is known of one parameter; its numbers have the unit that the control law gives it.
typedef struct
{
    const char* name;
    uint32_t set_command; ///< type of the command that sets it
    bool is_integer;      ///< sent as i32, else as f32
    float minimum;
    float maximum;
    float step;
    float default_value;
} parameter_definition_t;

extern const parameter_definition_t parameter_definitions[PARAMETER_COUNT];

#endif
