/// The board's sensing in the shared library, for tests in other languages: the models of the sensors around command
/// 50, and the estimate from their samples. One board for each process, because the models have one aircraft. No clock.
#ifndef EPF_SENSING_H
#define EPF_SENSING_H

#include <stddef.h>
#include <stdint.h>

#include "flight/board_sensors.h"

/// The readings that the board sends and flies by.
typedef struct
{
    message_ahrs_t ahrs;
    message_inertial_t inertial;
    message_analog_t analog;
} epf_sensing_readings_t;

/// Start a board on the runway; `seed` decides the errors of its sensors.
void epf_sensing_start(uint32_t seed);

/// Give the models a command 50, by its payload.
void epf_sensing_observe(const uint8_t payload[COMMAND_XPLANE_INFO_SIZE], float throttle);

/// One step of `dt_s` (> 0) of the sensor task, with or without samples of the gyro; returns the readings after it.
void epf_sensing_step(float dt_s, uint32_t is_gyro_silent, epf_sensing_readings_t* readings);

#endif
