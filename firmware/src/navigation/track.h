/// Ground track from a source that may only give the heading: the drift is computed from successive positions.
#ifndef NAVIGATION_TRACK_H
#define NAVIGATION_TRACK_H

#include <stdbool.h>
#include <stdint.h>

#include "navigation/geodesy.h"

typedef struct
{
    position_t anchor; ///< where the present stretch began
    bool has_anchor;
    float sin_sum; ///< of the direction given along the stretch, for its mean
    float cos_sum;
    uint32_t samples; ///< of the stretch
    float drift_deg;  ///< track less the given direction, smoothed
} track_t;

void track_init(track_t* track);

/// Take one position with the direction that came with it (ground track or heading, deg) and return the ground track
/// in [0, 360). For a source that gives the track itself, the result is that track plus the noise of the positions.
float track_update(track_t* track, const position_t* position, float direction_deg, float speed_kt);

/// The ground track in [0, 360) of a direction, by the drift known so far; nothing is taken.
float track_direction_deg(const track_t* track, float direction_deg);

#endif
