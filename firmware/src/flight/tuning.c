#include "flight/tuning.h"

#include "flight/gains.h"

/// Gains of the parameters, with the law and the line law's gains as they are.
static void refresh(tuning_t* tuning)
{
    const line_gains_t line = tuning->gains.line;
    const guidance_law_t law = tuning->gains.law;
    tuning->gains = gains_of(&tuning->parameters);
    tuning->gains.line = line;
    tuning->gains.law = law;
}

void tuning_init(tuning_t* tuning)
{
    parameters_init(&tuning->parameters);
    tuning->gains = gains_of(&tuning->parameters);
}

bool tuning_set(tuning_t* tuning, size_t index, float value)
{
    const bool is_set = parameters_set(&tuning->parameters, index, value);
    refresh(tuning);
    return is_set;
}

bool tuning_select_law(tuning_t* tuning, int32_t law)
{
    if (law != guidance_law_bearing && law != guidance_law_line)
    {
        return false;
    }
    tuning->gains.law = (guidance_law_t)law;
    return true;
}

bool tuning_set_line(tuning_t* tuning, size_t index, float value)
{
    return line_gains_set(&tuning->gains.line, index, value);
}

void tuning_replace(tuning_t* tuning, const parameters_t* parameters)
{
    tuning->parameters = *parameters;
    refresh(tuning);
}
