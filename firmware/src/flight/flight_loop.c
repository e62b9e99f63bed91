#include "flight/flight_loop.h"

#include <math.h>

#include "common/units.h"

void flight_loop_init(flight_loop_t* flight)
{
    control_loop_init(&flight->loop);
    flight->airspeed_source = COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_PITOT;
    flight->altitude_source = COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_BAROMETER;
}

/// The chosen source's value, or the other one's where the chosen source measures nothing; 0 without either.
static float first_measured(float chosen, float other)
{
    if (isfinite(chosen))
    {
        return chosen;
    }
    return isfinite(other) ? other : 0.0F;
}

control_loop_input_t flight_loop_input(const flight_loop_t* flight, const measurements_t* measured)
{
    const board_sensors_t* const sensors = &measured->sensors;
    const bool has_fix = sensors->gps.valid == 'A';
    const float gps_speed_kt = has_fix ? sensors->gps.speed_kt : NAN;
    const float gps_altitude_m = has_fix ? sensors->gps.altitude_m : NAN;
    const float pitot_speed_kt = sensors->analog.calibrated_airspeed_kt;
    const float baro_altitude_m = sensors->analog.altitude_m;
    const float speed_kt = flight->airspeed_source == COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_GPS
                               ? first_measured(gps_speed_kt, pitot_speed_kt)
                               : first_measured(pitot_speed_kt, gps_speed_kt);
    const float altitude_m = flight->altitude_source == COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_GPS
                                 ? first_measured(gps_altitude_m, baro_altitude_m)
                                 : first_measured(baro_altitude_m, gps_altitude_m);
    return (control_loop_input_t){
        .stick = measurements_stick(measured),
        .p_rad_s = sensors->inertial.gx_rad_s,
        .q_rad_s = sensors->inertial.gy_rad_s,
        .r_rad_s = sensors->inertial.gz_rad_s,
        .direction_deg = has_fix ? sensors->gps.heading_deg : sensors->ahrs.yaw_deg,
        .pitch_deg = sensors->ahrs.pitch_deg,
        .roll_deg = sensors->ahrs.roll_deg,
        .altitude_ft = altitude_m / M_PER_FT,
        .vvi_ft_min = first_measured(sensors->analog.vvi_ft_min, 0.0F),
        .speed_kt = speed_kt,
        .position =
            {
                .latitude_deg = has_fix ? (double)sensors->gps.latitude_deg : (double)NAN,
                .longitude_deg = (double)sensors->gps.longitude_deg,
            },
        .source = control_source_rc,
        .autopilot = measurements_autopilot(measured),
        .autotrim = measurements_autotrim(measured),
    };
}

/// A pilot flies by hand without attitude and altitude, so an unknown one counts as level flight at sea level.
static void fill_in(control_loop_input_t* input)
{
    float* const values[] = {&input->pitch_deg, &input->roll_deg, &input->direction_deg, &input->altitude_ft};
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++)
    {
        *values[i] = isfinite(*values[i]) ? *values[i] : 0.0F;
    }
}

void flight_loop_step(flight_loop_t* flight, const measurements_t* measured, const control_loop_gains_t* gains,
                      plan_t* plan, float dt_s)
{
    control_loop_t* const loop = &flight->loop;
    control_loop_input_t input = flight_loop_input(flight, measured);
    bool does[failsafe_action_count] = {false};
    for (size_t cause = failsafe_receiver_silent; cause < failsafe_count; cause++)
    {
        does[failsafe_action(&measured->missing, (failsafe_cause_t)cause, input.autopilot)] = true;
    }
    if (does[failsafe_neutral_surfaces])
    {
        control_loop_override(loop, &failsafe_surfaces);
        return;
    }
    if (does[failsafe_goes_undamped])
    {
        control_loop_override(loop, &input.stick);
        return;
    }
    if (does[failsafe_keeps_altitude])
    {
        input.altitude_ft = loop->hold.altitude_ft;
        input.vvi_ft_min = 0.0F;
    }
    if (!input.autopilot)
    {
        fill_in(&input);
    }
    (void)control_loop_step(loop, gains, plan, &input, dt_s);
}
