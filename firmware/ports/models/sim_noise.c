#include "sim_noise.h"

#include <math.h>

void sim_noise_init(sim_noise_t* noise, uint32_t seed)
{
    noise->state = seed;
}

/// SplitMix64: any seed works, also 0.
static uint64_t next(sim_noise_t* noise)
{
    noise->state += UINT64_C(0x9E3779B97F4A7C15);
    uint64_t mixed = noise->state;
    mixed = (mixed ^ (mixed >> 30U)) * UINT64_C(0xBF58476D1CE4E5B9);
    mixed = (mixed ^ (mixed >> 27U)) * UINT64_C(0x94D049BB133111EB);
    return mixed ^ (mixed >> 31U);
}

float sim_noise_uniform(sim_noise_t* noise)
{
    return (float)(next(noise) >> 40U) / 8388608.0F - 1.0F; // 24 bits, all that a float holds
}

float sim_noise_normal(sim_noise_t* noise, float sigma)
{
    // Twelve uniforms in [-1/2, 1/2) have variance 1 together.
    float sum = 0.0F;
    for (int i = 0; i < 12; i++)
    {
        sum += sim_noise_uniform(noise) / 2.0F;
    }
    return sum * sigma;
}

void sim_noise_wander(sim_noise_t* noise, float* error, float sigma, float time_s, float dt_s)
{
    const float kept = expf(-dt_s / time_s);
    *error = *error * kept + sim_noise_normal(noise, sigma * sqrtf(1.0F - kept * kept));
}

float sim_lag(float value, float target, float time_s, float dt_s)
{
    return value + (target - value) * (1.0F - expf(-dt_s / time_s));
}
