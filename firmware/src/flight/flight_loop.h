/// The real aircraft's control loop: what it takes from the sensors, and how it flies while some of them fail.
#ifndef FLIGHT_FLIGHT_LOOP_H
#define FLIGHT_FLIGHT_LOOP_H

#include <stdint.h>

#include "flight/control_loop.h"
#include "flight/measurements.h"

typedef struct
{
    control_loop_t loop;
    int32_t airspeed_source; ///< 0 GPS, 1 Pitot
    int32_t altitude_source; ///< 0 GPS, 1 barometer
} flight_loop_t;

/// Flown by the Pitot tube and the barometer.
void flight_loop_init(flight_loop_t* flight);

/// What the loop is given: sensors and receiver.
control_loop_input_t flight_loop_input(const flight_loop_t* flight, const measurements_t* measured);

/// One step of `dt_s` (> 0), by what `failsafe_table` says while measurements are missing.
void flight_loop_step(flight_loop_t* flight, const measurements_t* measured, const control_loop_gains_t* gains,
                      plan_t* plan, float dt_s);

#endif
