#include "flight/own_gains.h"

enum
{
    law_index = 0, ///< the line law's gains follow it in the order of their table
    first_line_index = 1
};

static const own_gain_t law = {
    .name = "guidance_law",
    .unit = "1",
    .group = "guidance",
    .choices = "deployed|line",
    .help = "How plans are flown: to the next waypoint, or along the line.",
    .minimum = (float)guidance_law_bearing,
    .maximum = (float)guidance_law_line,
    .step = 1.0F,
    .default_value = (float)guidance_law_bearing,
};

size_t own_gains_count(void)
{
    return (size_t)first_line_index + line_gains_count;
}

bool own_gains_describe(size_t index, own_gain_t* gain)
{
    if (index >= own_gains_count())
    {
        return false;
    }
    if (index == (size_t)law_index)
    {
        *gain = law;
        return true;
    }
    const line_gain_definition_t* const definition = &line_gain_definitions[index - (size_t)first_line_index];
    *gain = (own_gain_t){
        .name = definition->name,
        .unit = definition->unit,
        .group = definition->group,
        .choices = "",
        .help = definition->help,
        .minimum = definition->minimum,
        .maximum = definition->maximum,
        .step = definition->step,
        .default_value = definition->default_value,
    };
    return true;
}

float own_gains_get(const tuning_t* tuning, size_t index)
{
    if (index == (size_t)law_index)
    {
        return (float)tuning->gains.law;
    }
    return line_gains_get(&tuning->gains.line, index - (size_t)first_line_index);
}

void own_gains_copy(tuning_t* tuning, const tuning_t* other)
{
    tuning->gains.law = other->gains.law;
    tuning->gains.line = other->gains.line;
}

bool own_gains_set(tuning_t* tuning, size_t index, float value)
{
    if (index != (size_t)law_index)
    {
        return tuning_set_line(tuning, index - (size_t)first_line_index, value);
    }
    // written so that a NaN fails
    if (!(value >= law.minimum) || !(value <= law.maximum) || (float)(int32_t)value != value)
    {
        return false;
    }
    return tuning_select_law(tuning, (int32_t)value);
}
