/// The sensors of the board, and the receiver of the pilot's transmitter. Implemented by each port: drivers on
/// hardware, models on a PC. The readings are raw samples in the telemetry's units, axes and signs: the board estimates
/// attitude, altitude, climb and airspeed from them. NaN: not measured this time; the channels of a receiver that hears
/// nothing are NaN.
#ifndef HAL_SENSORS_H
#define HAL_SENSORS_H

#include "comms/protocol_gen.h"

typedef struct
{
    message_inertial_t inertial;
    message_analog_t analog; ///< without altitude, airspeed and climb, which the board computes: NaN
    message_gps_t gps;
    message_servos_in_t receiver;
} sensors_reading_t;

enum
{
    sensors_transmitter = -1
};

typedef struct
{
    void* context;

    /// Read everything once, `dt_s` (> 0) after the last time.
    void (*read)(void* context, float dt_s, sensors_reading_t* reading);

    /// The newest command 50, which models of sensors follow, and the throttle (0..1) that the board answered it with.
    /// NULL where the sensors are real.
    void (*observe)(void* context, const command_xplane_info_t* info, float throttle);

    /// Put a switch of the modelled transmitter (a receiver channel) to -1..+1, or the transmitter itself
    /// (`sensors_transmitter`) on (above 0) or off; NULL where the receiver is real.
    void (*set_switch)(void* context, int32_t channel, float position);
} sensors_t;

#endif
