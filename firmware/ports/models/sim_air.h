/// Models of the analog sensors: pressures, temperature and the battery.
#ifndef SIM_AIR_H
#define SIM_AIR_H

#include <stdbool.h>

#include "comms/protocol_gen.h"
#include "sim_noise.h"
#include "sim_truth.h"

typedef struct
{
    sim_noise_t noise;
    float baro_error_hpa; ///< wanders with the weather
    float external_error_m;
    float pitot_pa; ///< delayed by its tubing
    float temperature_degc;
    bool is_settled; ///< the lags have their initial value
    float charge;    ///< of the battery, 0..1
} sim_air_t;

void sim_air_init(sim_air_t* model, uint32_t seed);

/// One step of `dt_s` (> 0) with the motor at `throttle` (0..1).
void sim_air_read(sim_air_t* model, const sim_truth_t* truth, float throttle, float dt_s, message_analog_t* analog);

#endif
