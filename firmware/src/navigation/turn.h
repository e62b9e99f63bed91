/// How far before a waypoint the turn onto the next leg has to begin.
#ifndef NAVIGATION_TURN_H
#define NAVIGATION_TURN_H

#include <stdbool.h>

#include "navigation/wind.h"

typedef struct
{
    float lead_m;   ///< along the leg before the waypoint, >= 0
    float radius_m; ///< of the turn over the ground, in its middle
    bool is_sharp;  ///< the lead is capped: the aircraft swings beyond the next leg and comes back
} turn_t;

/// The turn from one course to another at a bank, through the estimated wind: the way through the air is part of a
/// circle, the way over the ground that and the wind's. `roll_time_s`: lag of the bank behind its command.
turn_t turn_between(float from_deg, float to_deg, const wind_t* wind, float airspeed_m_s, float bank_deg,
                    float roll_time_s);

#endif
