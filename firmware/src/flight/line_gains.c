#include "flight/line_gains.h"

// Found in the closed loop with the simulated 12 kg aircraft: calm, in 25 kt and in turbulence.
const line_gain_definition_t line_gain_definitions[] = {
    {"line_bank_limit", "deg", "line_course", "Largest bank that the law asks for.", 30.0F, 10.0F, 60.0F, 1.0F,
     offsetof(line_gains_t, follow.bank_limit_deg)},
    {"line_approach", "s", "line_course", "Time in which a small distance from the line shrinks to a third.", 3.0F,
     1.0F, 20.0F, 0.1F, offsetof(line_gains_t, follow.approach_time_s)},
    {"line_k_course", "1/s", "line_course", "Turn rate per course error.", 0.9F, 0.1F, 5.0F, 0.1F,
     offsetof(line_gains_t, follow.k_course_per_s)},
    {"line_k_bank", "1/rad", "line_course", "Aileron command per rad of bank error.", 3.0F, 0.1F, 10.0F, 0.1F,
     offsetof(line_gains_t, follow.k_bank)},
    {"line_k_int_bank", "1/s", "line_course", "Share of line_k_bank that is added each second.", 0.5F, 0.0F, 5.0F, 0.1F,
     offsetof(line_gains_t, follow.k_int_bank_per_s)},
    {"line_roll_time", "s", "line_course", "Lag of the bank: turns begin earlier by it.", 1.1F, 0.0F, 5.0F, 0.1F,
     offsetof(line_gains_t, roll_time_s)},
    {"line_k_climb", "1/s", "line_altitude", "Climb per altitude error.", 0.5F, 0.02F, 2.0F, 0.01F,
     offsetof(line_gains_t, energy.k_climb_per_s)},
    {"line_k_path", "1", "line_altitude", "Path angle per path angle error.", 1.0F, 0.0F, 5.0F, 0.1F,
     offsetof(line_gains_t, energy.k_path)},
    {"line_k_int_path", "1/s", "line_altitude", "Pitch per path angle error and second.", 0.3F, 0.0F, 2.0F, 0.01F,
     offsetof(line_gains_t, energy.k_int_path_per_s)},
    {"line_k_pitch", "1/rad", "line_altitude", "Elevator command per rad of pitch error.", 2.0F, 0.1F, 10.0F, 0.1F,
     offsetof(line_gains_t, energy.k_pitch)},
    {"line_k_accelerate", "1/s", "line_energy", "Acceleration per speed error.", 0.3F, 0.02F, 2.0F, 0.01F,
     offsetof(line_gains_t, energy.k_accelerate_per_s)},
    {"line_k_feed", "s/m", "line_energy", "Throttle per m/s of wanted energy rate, as height.", 0.04F, 0.0F, 1.0F,
     0.01F, offsetof(line_gains_t, energy.k_feed_s_per_m)},
    {"line_k_energy", "s/m", "line_energy", "Throttle per m/s of error of the energy rate.", 0.03F, 0.0F, 1.0F, 0.01F,
     offsetof(line_gains_t, energy.k_energy_s_per_m)},
    {"line_k_int_energy", "1/m", "line_energy", "Throttle per m of error of the energy, as height.", 0.02F, 0.0F, 1.0F,
     0.01F, offsetof(line_gains_t, energy.k_int_energy_per_m)},
    {"line_climb_limit", "ft/min", "line_altitude", "Fastest climb that the law asks for.", 800.0F, 100.0F, 5000.0F,
     50.0F, offsetof(line_gains_t, energy.climb_limit_ft_min)},
    {"line_sink_limit", "ft/min", "line_altitude", "Fastest descent that the law asks for.", 500.0F, 100.0F, 5000.0F,
     50.0F, offsetof(line_gains_t, energy.sink_limit_ft_min)},
    {"line_load_limit", "g", "line_altitude", "Largest change of the load factor beside that of the turn.", 1.0F, 0.2F,
     3.0F, 0.1F, offsetof(line_gains_t, energy.load_limit_g)},
    {"line_k_rudder", "1", "line_course", "Yaw damper; less of it bears more delay.", 0.3F, 0.0F, 10.0F, 0.1F,
     offsetof(line_gains_t, k_rudder)},
};

const size_t line_gains_count = sizeof line_gain_definitions / sizeof line_gain_definitions[0];

static float* place_of(line_gains_t* gains, size_t index)
{
    return (float*)(void*)((char*)gains + line_gain_definitions[index].offset);
}

line_gains_t line_gains_default(void)
{
    line_gains_t gains = {0};
    for (size_t i = 0; i < line_gains_count; i++)
    {
        *place_of(&gains, i) = line_gain_definitions[i].default_value;
    }
    return gains;
}

float line_gains_get(const line_gains_t* gains, size_t index)
{
    line_gains_t copy = *gains;
    return index < line_gains_count ? *place_of(&copy, index) : 0.0F;
}

bool line_gains_set(line_gains_t* gains, size_t index, float value)
{
    // written so that a NaN fails
    if (index >= line_gains_count || !(value >= line_gain_definitions[index].minimum) ||
        !(value <= line_gain_definitions[index].maximum))
    {
        return false;
    }
    *place_of(gains, index) = value;
    return true;
}
