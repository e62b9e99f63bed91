#include "flight/tuning.h"

#include "flight/gains.h"

void tuning_init(tuning_t* tuning)
{
    parameters_init(&tuning->parameters);
    tuning->gains = gains_of(&tuning->parameters);
}

bool tuning_set(tuning_t* tuning, size_t index, float value)
{
    const bool is_set = parameters_set(&tuning->parameters, index, value);
    tuning->gains = gains_of(&tuning->parameters);
    return is_set;
}

void tuning_replace(tuning_t* tuning, const parameters_t* parameters)
{
    tuning->parameters = *parameters;
    tuning->gains = gains_of(parameters);
}
