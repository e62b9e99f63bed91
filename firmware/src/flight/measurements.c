#include "flight/measurements.h"

#include <math.h>

#include "control/surfaces.h"

static bool is_complete(const message_servos_in_t* receiver)
{
    for (size_t i = 0; i < sizeof receiver->channel / sizeof receiver->channel[0]; i++)
    {
        if (!isfinite(receiver->channel[i]))
        {
            return false;
        }
    }
    return true;
}

bool measurements_hear_receiver(measurements_t* measured)
{
    const bool is_heard = is_complete(&measured->sensors.servos_in);
    if (is_heard)
    {
        measured->receiver_heard = measured->sensors.servos_in;
    }
    return is_heard;
}

void measurements_note(measurements_t* measured, float dt_s)
{
    const board_sensors_t* const sensors = &measured->sensors;
    failsafe_t* const missing = &measured->missing;
    const bool is_receiver_heard = measurements_hear_receiver(measured);
    const bool has_rates = isfinite(sensors->inertial.gx_rad_s) && isfinite(sensors->inertial.gy_rad_s) &&
                           isfinite(sensors->inertial.gz_rad_s);
    const bool has_fix = sensors->gps.valid == 'A';
    const bool has_direction = isfinite(sensors->ahrs.yaw_deg) || (has_fix && isfinite(sensors->gps.heading_deg));
    const bool has_attitude = isfinite(sensors->ahrs.pitch_deg) && isfinite(sensors->ahrs.roll_deg) && has_direction;
    const bool has_altitude = isfinite(sensors->analog.altitude_m) || (has_fix && isfinite(sensors->gps.altitude_m));
    failsafe_note(missing, failsafe_receiver_silent, !is_receiver_heard, dt_s);
    failsafe_note(missing, failsafe_rates_unknown, !has_rates, dt_s);
    failsafe_note(missing, failsafe_attitude_unknown, !has_attitude, dt_s);
    failsafe_note(missing, failsafe_altitude_unknown, !has_altitude, dt_s);
}

float measurements_channel(const measurements_t* measured, size_t channel)
{
    const float newest = measured->sensors.servos_in.channel[channel];
    return isfinite(newest) ? newest : measured->receiver_heard.channel[channel];
}

bool measurements_autopilot(const measurements_t* measured)
{
    return measurements_channel(measured, rc_channel_autopilot) > 0.0F;
}

bool measurements_autotrim(const measurements_t* measured)
{
    return measurements_channel(measured, rc_channel_autotrim) > 0.0F;
}

surfaces_t measurements_stick(const measurements_t* measured)
{
    if (failsafe_action(&measured->missing, failsafe_receiver_silent, false) == failsafe_lets_stick_go)
    {
        return failsafe_surfaces;
    }
    const surfaces_t stick = {
        .elevator = measurements_channel(measured, rc_channel_elevator),
        .aileron = measurements_channel(measured, rc_channel_aileron),
        .rudder = measurements_channel(measured, rc_channel_rudder),
        .throttle = measurements_channel(measured, rc_channel_throttle),
    };
    return surfaces_in_limits(&stick);
}
