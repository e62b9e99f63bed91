/// From the sensors' samples to what the board says and flies by: the estimator's state in the telemetry's units.
#ifndef APP_SENSING_H
#define APP_SENSING_H

#include "estimation/estimator.h"
#include "flight/board_sensors.h"
#include "hal/sensors.h"

/// An estimator that knows nothing yet, for where the board flies.
void sensing_init(estimator_t* estimator);

/// Take one reading, `dt_s` (> 0) after the last, and put everything but the statistics into `sensors`.
void sensing_update(estimator_t* estimator, const sensors_reading_t* reading, float dt_s, board_sensors_t* sensors);

#endif
