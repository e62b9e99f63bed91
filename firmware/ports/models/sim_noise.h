/// Reproducible noise for the sensor models: the same seed and the same calls give the same numbers.
#ifndef SIM_NOISE_H
#define SIM_NOISE_H

#include <stdint.h>

typedef struct
{
    uint64_t state;
} sim_noise_t;

void sim_noise_init(sim_noise_t* noise, uint32_t seed);

/// Uniform in [-1, 1).
float sim_noise_uniform(sim_noise_t* noise);

/// About normal, with mean 0 and standard deviation `sigma` (never beyond 6 of it).
float sim_noise_normal(sim_noise_t* noise, float sigma);

/// One step of `dt_s` of a Gauss-Markov error with standard deviation `sigma` and correlation time `time_s`.
void sim_noise_wander(sim_noise_t* noise, float* error, float sigma, float time_s, float dt_s);

/// One step of `dt_s` of a first-order lag of `time_s`.
float sim_lag(float value, float target, float time_s, float dt_s);

#endif
