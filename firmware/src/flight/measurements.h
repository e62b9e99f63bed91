/// What the real aircraft is flown by: the newest readings, the receiver's channels as last heard, and how long each
/// measurement that a failsafe depends on has been missing.
#ifndef FLIGHT_MEASUREMENTS_H
#define FLIGHT_MEASUREMENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "control/fly_by_wire.h"
#include "flight/board_sensors.h"
#include "flight/failsafe.h"

typedef struct
{
    board_sensors_t sensors;
    message_servos_in_t receiver_heard; ///< the newest complete reading of the receiver
    failsafe_t missing;                 ///< every cause but the silent simulator
} measurements_t;

/// Remember the receiver's channels if all of them are there; returns whether they are. To be called with each new
/// reading: the control loop runs by its own clock and may miss one, and with it the last position of a switch.
bool measurements_hear_receiver(measurements_t* measured);

/// Count how long each measurement has been missing: `dt_s` (> 0) have passed since the last call.
void measurements_note(measurements_t* measured, float dt_s);

/// The receiver's channel as it was heard last.
float measurements_channel(const measurements_t* measured, size_t channel);

/// Autopilot and autotrim as the transmitter's switches ask for them.
bool measurements_autopilot(const measurements_t* measured);
bool measurements_autotrim(const measurements_t* measured);

/// The stick of the transmitter; neutral, with the failsafe's throttle, once the receiver is silent.
surfaces_t measurements_stick(const measurements_t* measured);

#endif
