#include "navigation/track.h"

#include <math.h>

#include "common/angle.h"

// A stretch has to be long compared with the resolution of a float of degrees (1-2 m) and short compared with a turn.
// One longer than the maximum is no flight: the simulator moved the aircraft.
static const float stretch_minimum_m = 40.0F;
static const float stretch_maximum_m = 200.0F;
static const float speed_minimum_kt = 20.0F;
static const float smoothing = 0.2F;        ///< share of a new stretch in the drift
static const float drift_limit_deg = 60.0F; ///< a larger angle cannot be drift and is ignored
static const float straight_minimum =
    0.98F; ///< mean length of the directions' unit vectors; below it the stretch was a turn

void track_init(track_t* track)
{
    *track = (track_t){.has_anchor = false};
}

static void begin_stretch(track_t* track, const position_t* position)
{
    track->anchor = *position;
    track->has_anchor = true;
    track->sin_sum = 0.0F;
    track->cos_sum = 0.0F;
    track->samples = 0;
}

static void end_stretch(track_t* track, const position_t* position)
{
    const float flown_deg = geodesy_bearing_deg(&track->anchor, position);
    const float given_deg = angle_to_deg(atan2f(track->sin_sum, track->cos_sum));
    const float drift_deg = angle_wrap_180(flown_deg - given_deg);
    const float length = hypotf(track->sin_sum, track->cos_sum) / (float)track->samples;
    if (length >= straight_minimum && fabsf(drift_deg) <= drift_limit_deg)
    {
        track->drift_deg += smoothing * (drift_deg - track->drift_deg);
    }
    begin_stretch(track, position);
}

float track_direction_deg(const track_t* track, float direction_deg)
{
    return angle_wrap_360(direction_deg + track->drift_deg);
}

float track_update(track_t* track, const position_t* position, float direction_deg, float speed_kt)
{
    if (!position_is_valid(position) || !(speed_kt >= speed_minimum_kt))
    {
        track_init(track);
        return angle_wrap_360(direction_deg);
    }
    if (!track->has_anchor)
    {
        begin_stretch(track, position);
    }
    track->sin_sum += sinf(angle_to_rad(direction_deg));
    track->cos_sum += cosf(angle_to_rad(direction_deg));
    track->samples++;
    const float flown_m = geodesy_distance_m(&track->anchor, position);
    if (flown_m > stretch_maximum_m)
    {
        begin_stretch(track, position);
    }
    else if (flown_m >= stretch_minimum_m)
    {
        end_stretch(track, position);
    }
    return track_direction_deg(track, direction_deg);
}
