/// The straight leg between two waypoints, and where an aircraft is along it.
///
/// A leg is straight on the plane of longitude and latitude, scaled at its end; legs are short enough for that.
#ifndef NAVIGATION_LEG_H
#define NAVIGATION_LEG_H

#include "navigation/geodesy.h"

typedef struct
{
    position_t end;
    float course_deg; ///< 0..360
    float length_m;
    float north; ///< unit vector of the course
    float east;
} leg_t;

typedef struct
{
    float north_m;
    float east_m;
} offset_t;

typedef struct
{
    float remaining_m; ///< along the leg to its end; negative beyond it
    float right_m;     ///< from the leg's line, + right of it
} leg_place_t;

/// Offset of `place` from `origin`, on a plane scaled at `origin`.
offset_t leg_offset_m(const position_t* origin, const position_t* place);

/// The leg from `begin` to `end`. A leg shorter than a metre points along `course_deg`.
leg_t leg_between(const position_t* begin, const position_t* end, float course_deg);

leg_place_t leg_place(const leg_t* leg, const position_t* position);

#endif
