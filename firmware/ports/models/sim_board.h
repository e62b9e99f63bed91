/// Sensors, GPS, RC receiver and servos, which a PC lacks, as models around the newest simulator information. Before
/// the first of it, the board stands on Gran Canaria's runway. When it stops, the aircraft stands still in the air, as
/// in a paused simulator.
#ifndef SIM_BOARD_H
#define SIM_BOARD_H

#include <stdint.h>

#include "hal/sensors.h"
#include "hal/servos.h"

/// The sensors and the receiver; `seed` decides their errors.
sensors_t sim_board_sensors(uint32_t seed);

/// The servos; the motor discharges the battery that the sensors measure.
servos_t sim_board_servos(void);

#endif
