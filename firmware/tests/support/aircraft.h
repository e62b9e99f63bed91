/// A small aircraft to close the loops on: rates that follow the surfaces, a flight path that follows the nose, thrust
/// and drag. Not a real one; real flight dynamics are flown from Python through the same code.
#ifndef SUPPORT_AIRCRAFT_H
#define SUPPORT_AIRCRAFT_H

#include "control/fly_by_wire.h"
#include "flight/control_loop.h"

typedef struct
{
    double latitude_deg;
    double longitude_deg;
    double altitude_ft;
    double speed_kt; ///< airspeed
    double heading_deg;
    double pitch_deg;
    double roll_deg;
    double climb_deg; ///< flight path above the horizon
    double p_rad_s;
    double q_rad_s;
    double wind_north_kt; ///< towards the north
    double wind_east_kt;
    double track_deg;
} aircraft_t;

/// Level at 1000 ft and 55 kt over the airport, to the north-east, no wind.
void aircraft_init(aircraft_t* aircraft);

/// Fly for `dt_s` with these surfaces.
void aircraft_step(aircraft_t* aircraft, const surfaces_t* surfaces, double dt_s);

/// What a simulator would say of it, with the ground track as direction.
control_loop_input_t aircraft_state(const aircraft_t* aircraft);

#endif
