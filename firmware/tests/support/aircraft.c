#include "support/aircraft.h"

#include <math.h>

#include "common/angle.h"

static const double rad = 0.017453292519943295;
static const double ft_per_nmi = 6076.115;
static const double level_elevator = -0.15; ///< to fly level at any speed; more than the autopilot itself commands
static const double level_alpha_deg = 3.0;

void aircraft_init(aircraft_t* aircraft)
{
    *aircraft = (aircraft_t){
        .latitude_deg = 27.9319,
        .longitude_deg = -15.3866,
        .altitude_ft = 1000.0,
        .speed_kt = 55.0,
        .heading_deg = 30.0,
        .pitch_deg = level_alpha_deg,
        .track_deg = 30.0,
    };
}

void aircraft_step(aircraft_t* aircraft, const surfaces_t* surfaces, double dt_s)
{
    const double pressure = (aircraft->speed_kt / 55.0) * (aircraft->speed_kt / 55.0);
    // a full aileron rolls with 2 rad/s at 55 kt, a full elevator pitches with 1.5 rad/s; both within 0.2 s
    aircraft->p_rad_s += (2.0 * pressure * (double)surfaces->aileron - aircraft->p_rad_s) * dt_s / 0.2;
    const double wanted_q = 1.5 * pressure * ((double)surfaces->elevator - level_elevator);
    aircraft->q_rad_s += (wanted_q - aircraft->q_rad_s) * dt_s / 0.2;
    aircraft->roll_deg += aircraft->p_rad_s / rad * dt_s;
    aircraft->pitch_deg += aircraft->q_rad_s / rad * cos(aircraft->roll_deg * rad) * dt_s;
    // the path follows the nose within 0.8 s; a bank costs lift
    const double bank_loss_deg = 2.0 * (1.0 / cos(aircraft->roll_deg * rad) - 1.0);
    const double wanted_climb_deg = aircraft->pitch_deg - level_alpha_deg / pressure - bank_loss_deg;
    aircraft->climb_deg += (wanted_climb_deg - aircraft->climb_deg) * dt_s / 0.8;
    const double thrust_kt_s = 9.0 * (double)surfaces->throttle;
    const double drag_kt_s = 4.0 * pressure;
    aircraft->speed_kt += (thrust_kt_s - drag_kt_s - 19.06 * sin(aircraft->climb_deg * rad)) * dt_s;
    aircraft->speed_kt = fmax(aircraft->speed_kt, 1.0);
    // g tan(roll) / V, with g = 19.06 kt/s
    aircraft->heading_deg += 19.06 * tan(aircraft->roll_deg * rad) / aircraft->speed_kt / rad * dt_s;
    const double along_kt = aircraft->speed_kt * cos(aircraft->climb_deg * rad);
    const double north_kt = along_kt * cos(aircraft->heading_deg * rad) + aircraft->wind_north_kt;
    const double east_kt = along_kt * sin(aircraft->heading_deg * rad) + aircraft->wind_east_kt;
    aircraft->track_deg = atan2(east_kt, north_kt) / rad;
    aircraft->latitude_deg += north_kt / 3600.0 / 60.0 * dt_s;
    aircraft->longitude_deg += east_kt / 3600.0 / 60.0 / cos(aircraft->latitude_deg * rad) * dt_s;
    aircraft->altitude_ft += aircraft->speed_kt * sin(aircraft->climb_deg * rad) * ft_per_nmi / 3600.0 * dt_s;
}

control_loop_input_t aircraft_state(const aircraft_t* aircraft)
{
    return (control_loop_input_t){
        .p_rad_s = (float)aircraft->p_rad_s,
        .q_rad_s = (float)aircraft->q_rad_s,
        .direction_deg = (float)aircraft->track_deg,
        .pitch_deg = (float)aircraft->pitch_deg,
        .roll_deg = (float)aircraft->roll_deg,
        .altitude_ft = (float)aircraft->altitude_ft,
        .vvi_ft_min = (float)(aircraft->speed_kt * sin(aircraft->climb_deg * rad) * ft_per_nmi / 60.0),
        .speed_kt = (float)aircraft->speed_kt,
        .position = {(double)(float)aircraft->latitude_deg, (double)(float)aircraft->longitude_deg},
    };
}
