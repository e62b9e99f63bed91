/// The wind, estimated from successive positions and the airspeed: a Kalman filter whose only measurement is that the
/// ground velocity less the wind has the length of the airspeed. The component along the track is known at once, the
/// one across it after a turn.
#ifndef NAVIGATION_WIND_H
#define NAVIGATION_WIND_H

#include <stdbool.h>

#include "navigation/geodesy.h"

typedef struct
{
    float north_m_s; ///< of the moving air: the wind blows to there
    float east_m_s;
    float variance_north; ///< m2/s2
    float variance_east;
    float covariance;
    position_t anchor; ///< where the present stretch began
    bool has_anchor;
    float stretch_s;
    float airspeed_sum_m; ///< flown through the air along the stretch
} wind_t;

/// The wind as people say it.
typedef struct
{
    float from_deg; ///< it blows from there, clockwise from true north, 0 to 360
    float speed_m_s;
    float deviation_m_s; ///< one standard deviation of its velocity, in the direction where that is largest
} wind_estimate_t;

/// No wind, as far as is known.
void wind_init(wind_t* wind);

/// The aircraft has flown for `dt_s` (>= 0) at `airspeed_m_s`, true, and is at `position` now.
void wind_update(wind_t* wind, const position_t* position, float airspeed_m_s, float dt_s);

/// The wind that is known. False, and nothing written, while nothing is, or without a position to learn from.
bool wind_estimate(const wind_t* wind, wind_estimate_t* estimate);

/// Ground speed in m/s (>= 0) along the track `track_deg`; 0 where the wind is stronger than the aircraft.
float wind_ground_speed_m_s(const wind_t* wind, float airspeed_m_s, float track_deg);

/// Heading in deg that keeps the track `track_deg`; at most 80 deg from it.
float wind_heading_deg(const wind_t* wind, float airspeed_m_s, float track_deg);

#endif
