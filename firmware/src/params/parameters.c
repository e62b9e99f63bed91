#include "params/parameters.h"

#include <math.h>
#include <string.h>

void parameters_init(parameters_t* parameters)
{
    for (size_t i = 0; i < parameters_count; i++)
    {
        parameters->values[i] = parameter_definitions[i].default_value;
    }
}

static bool is_allowed(const parameter_definition_t* definition, float value)
{
    // written so that a NaN fails
    const bool in_range = value >= definition->minimum && value <= definition->maximum;
    return in_range && (!definition->is_integer || floorf(value) == value);
}

bool parameters_set(parameters_t* parameters, size_t index, float value)
{
    if (index >= parameters_count || !is_allowed(&parameter_definitions[index], value))
    {
        return false;
    }
    parameters->values[index] = value;
    return true;
}

bool parameters_are_valid(const parameters_t* parameters)
{
    for (size_t i = 0; i < parameters_count; i++)
    {
        if (!is_allowed(&parameter_definitions[i], parameters->values[i]))
        {
            return false;
        }
    }
    return true;
}

int32_t parameters_index_of_command(uint32_t type_id)
{
    for (size_t i = 0; i < parameters_count; i++)
    {
        if (parameter_definitions[i].set_command == type_id)
        {
            return (int32_t)i;
        }
    }
    return -1;
}

int32_t parameters_index_of_name(const char* name)
{
    for (size_t i = 0; i < parameters_count; i++)
    {
        if (strcmp(parameter_definitions[i].name, name) == 0)
        {
            return (int32_t)i;
        }
    }
    return -1;
}
