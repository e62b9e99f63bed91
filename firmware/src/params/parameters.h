/// The 17 parameters of the control laws, in the order of telemetry type 11, with their checks.
#ifndef PARAMS_PARAMETERS_H
#define PARAMS_PARAMETERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "params/parameters_gen.h"

enum
{
    parameters_count = PARAMETER_COUNT
};

/// Values in the order of the generated table; `k_div_velocidad` is a whole number.
typedef struct
{
    float values[parameters_count];
} parameters_t;

/// All defaults.
void parameters_init(parameters_t* parameters);

/// Set one by its place in the table. False, and nothing changed, when the index is not 0..16, the value is not
/// finite, outside of its range, or not whole where it has to be.
bool parameters_set(parameters_t* parameters, size_t index, float value);

/// True when every value is finite and in its range.
bool parameters_are_valid(const parameters_t* parameters);

/// Place in the table of the parameter that command `type_id` (60..76) sets, or -1.
int32_t parameters_index_of_command(uint32_t type_id);

/// Place in the table of the parameter called `name`, or -1.
int32_t parameters_index_of_name(const char* name);

#endif
