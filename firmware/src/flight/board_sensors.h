/// What the board's sensors and its receiver measured last. The application writes it; the board sends it and flies by
/// it.
#ifndef FLIGHT_BOARD_SENSORS_H
#define FLIGHT_BOARD_SENSORS_H

#include "comms/protocol_gen.h"

/// Receiver channels (index into `servos_in`). A switch is on above 0.
enum
{
    rc_channel_aileron = 0,
    rc_channel_elevator = 1,
    rc_channel_throttle = 2, ///< 0..1, as the deployed boards send it
    rc_channel_rudder = 3,
    rc_channel_autopilot = 4, ///< the "automatic" switch
    rc_channel_autotrim = 5
};

/// NaN: not measured.
typedef struct
{
    message_ahrs_t ahrs;
    message_inertial_t inertial;
    message_analog_t analog;
    message_servos_in_t servos_in;
    message_gps_t gps;
    message_statistics_t statistics;
} board_sensors_t;

#endif
