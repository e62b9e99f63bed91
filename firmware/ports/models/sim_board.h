/// The hardware that a PC lacks: sensors, GPS, the RC receiver and the servos, as models around the newest simulator
/// information. Without any, the board stands on Gran Canaria's runway; when it stops, the aircraft hangs still in the
/// air, as it does in a simulator that is paused.
#ifndef SIM_BOARD_H
#define SIM_BOARD_H

#include <stdint.h>

#include "hal/sensors.h"
#include "hal/servos.h"

/// The sensors and the receiver; `seed` decides their errors.
sensors_t sim_board_sensors(uint32_t seed);

/// The servos; the motor's draws from the battery that the sensors measure.
servos_t sim_board_servos(void);

#endif
