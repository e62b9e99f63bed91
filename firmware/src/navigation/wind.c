#include "navigation/wind.h"

#include <math.h>

#include "common/angle.h"
#include "common/limit.h"
#include "navigation/leg.h"

// A stretch has to be long compared with the resolution of a position (0.2 m) and short compared with a turn.
static const float stretch_minimum_s = 0.5F;
static const float slowest_m_s = 10.0F;
static const float fastest_ratio = 3.0F;           ///< of ground speed to airspeed; beyond, the aircraft was moved
static const float initial_variance = 64.0F;       ///< 8 m/s each way
static const float drift_variance_per_s = 0.01F;   ///< how quickly a wind changes
static const float measurement_variance = 6.0F;    ///< gusts, mostly
static const float sharpest_crab = 0.98480775301F; ///< sine of 80 deg

void wind_init(wind_t* wind)
{
    *wind = (wind_t){.variance_north = initial_variance, .variance_east = initial_variance};
}

static void begin_stretch(wind_t* wind, const position_t* position)
{
    wind->anchor = *position;
    wind->has_anchor = true;
    wind->stretch_s = 0.0F;
    wind->airspeed_sum_m = 0.0F;
}

/// Correct the wind by one stretch. As long as the wind across the track is unknown, the airspeed says less of the wind
/// along it: one across makes it longer.
static void correct(wind_t* wind, float north_m_s, float east_m_s, float airspeed_m_s)
{
    const float air_north_m_s = north_m_s - wind->north_m_s;
    const float air_east_m_s = east_m_s - wind->east_m_s;
    const float predicted_m_s = fmaxf(hypotf(air_north_m_s, air_east_m_s), 1.0F);
    const float slope_north = -air_north_m_s / predicted_m_s;
    const float slope_east = -air_east_m_s / predicted_m_s;
    const float cross_north = wind->variance_north * slope_north + wind->covariance * slope_east;
    const float cross_east = wind->covariance * slope_north + wind->variance_east * slope_east;
    const float across_variance = slope_east * slope_east * wind->variance_north +
                                  slope_north * slope_north * wind->variance_east -
                                  2.0F * slope_north * slope_east * wind->covariance;
    const float longer_m_s = 0.5F * across_variance / predicted_m_s;
    const float variance =
        slope_north * cross_north + slope_east * cross_east + measurement_variance + 2.0F * longer_m_s * longer_m_s;
    const float innovation_m_s = airspeed_m_s - predicted_m_s;
    wind->north_m_s += cross_north / variance * innovation_m_s;
    wind->east_m_s += cross_east / variance * innovation_m_s;
    wind->variance_north -= cross_north * cross_north / variance;
    wind->variance_east -= cross_east * cross_east / variance;
    wind->covariance -= cross_north * cross_east / variance;
}

static void end_stretch(wind_t* wind, const position_t* position)
{
    const offset_t flown = leg_offset_m(&wind->anchor, position);
    const float airspeed_m_s = wind->airspeed_sum_m / wind->stretch_s;
    const float north_m_s = flown.north_m / wind->stretch_s;
    const float east_m_s = flown.east_m / wind->stretch_s;
    const float drift = drift_variance_per_s * wind->stretch_s;
    wind->variance_north = fminf(wind->variance_north + drift, initial_variance);
    wind->variance_east = fminf(wind->variance_east + drift, initial_variance);
    if (airspeed_m_s >= slowest_m_s && hypotf(north_m_s, east_m_s) < fastest_ratio * airspeed_m_s)
    {
        correct(wind, north_m_s, east_m_s, airspeed_m_s);
    }
    begin_stretch(wind, position);
}

void wind_update(wind_t* wind, const position_t* position, float airspeed_m_s, float dt_s)
{
    if (!position_is_valid(position))
    {
        wind->has_anchor = false;
        return;
    }
    if (!wind->has_anchor || !(dt_s > 0.0F))
    {
        // a step without time follows a pause: nobody knows how far the stretch would go
        begin_stretch(wind, position);
        return;
    }
    wind->stretch_s += dt_s;
    wind->airspeed_sum_m += airspeed_m_s * dt_s;
    if (wind->stretch_s >= stretch_minimum_s)
    {
        end_stretch(wind, position);
    }
}

bool wind_estimate(const wind_t* wind, wind_estimate_t* estimate)
{
    const bool is_measured = wind->variance_north < initial_variance || wind->variance_east < initial_variance;
    if (!wind->has_anchor || !is_measured)
    {
        return false;
    }
    // the larger axis of the ellipse of errors
    const float mean = 0.5F * (wind->variance_north + wind->variance_east);
    const float largest = mean + hypotf(0.5F * (wind->variance_north - wind->variance_east), wind->covariance);
    *estimate = (wind_estimate_t){
        .from_deg = angle_wrap_360(angle_to_deg(atan2f(-wind->east_m_s, -wind->north_m_s))),
        .speed_m_s = hypotf(wind->north_m_s, wind->east_m_s),
        .deviation_m_s = sqrtf(fmaxf(largest, 0.0F)),
    };
    return true;
}

/// Sine of the angle that the heading is to the left of the track, against a wind from there.
static float crab_sine(const wind_t* wind, float airspeed_m_s, float sin_track, float cos_track)
{
    const float to_right_m_s = wind->east_m_s * cos_track - wind->north_m_s * sin_track;
    return limit_to(to_right_m_s / fmaxf(airspeed_m_s, 1.0F), -sharpest_crab, sharpest_crab);
}

float wind_ground_speed_m_s(const wind_t* wind, float airspeed_m_s, float track_deg)
{
    const float sin_track = sinf(angle_to_rad(track_deg));
    const float cos_track = cosf(angle_to_rad(track_deg));
    const float crab = crab_sine(wind, airspeed_m_s, sin_track, cos_track);
    const float along_m_s = wind->north_m_s * cos_track + wind->east_m_s * sin_track;
    return fmaxf(airspeed_m_s * sqrtf(1.0F - crab * crab) + along_m_s, 0.0F);
}

float wind_heading_deg(const wind_t* wind, float airspeed_m_s, float track_deg)
{
    const float sin_track = sinf(angle_to_rad(track_deg));
    const float cos_track = cosf(angle_to_rad(track_deg));
    return track_deg - angle_to_deg(asinf(crab_sine(wind, airspeed_m_s, sin_track, cos_track)));
}
