/// From the sensors' samples to the readings that the board sends and flies by, in the telemetry's units.
#ifndef APP_SENSING_H
#define APP_SENSING_H

#include "estimation/estimator.h"
#include "flight/board_sensors.h"
#include "hal/sensors.h"

/// Take one reading, `dt_s` (> 0) after the last, and write all of `sensors` except the statistics.
void sensing_update(estimator_t* estimator, const sensors_reading_t* reading, float dt_s, board_sensors_t* sensors);

#endif
