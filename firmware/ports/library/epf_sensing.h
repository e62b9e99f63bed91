/// What the board senses in the shared library, for tests in other languages: its models of the sensors around command
/// 50, and what it estimates from them. There is one board in a process, as its models have one aircraft. No clock.
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

/// A board just switched on, on the runway; `seed` decides its sensors' errors.
void epf_sensing_start(uint32_t seed);

/// A command 50 came in: its payload.
void epf_sensing_observe(const uint8_t payload[COMMAND_XPLANE_INFO_SIZE], float throttle);

/// One step of `dt_s` (> 0) of the sensor task, the gyro silent in it or not, and the readings after it.
void epf_sensing_step(float dt_s, uint32_t is_gyro_silent, epf_sensing_readings_t* readings);

#endif
