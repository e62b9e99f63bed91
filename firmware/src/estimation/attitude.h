/// Attitude and heading: the integrated gyro, corrected by the measured gravity and by the compass.
///
/// A complementary filter on a quaternion. The accelerometer corrects tilt only and the magnetometer heading only, so a
/// disturbed magnetic field does not tilt the horizon. Both correct the gyro's bias all the time. North is magnetic
/// here, so that nothing turns when the declination changes; the estimator makes headings true.
#ifndef ESTIMATION_ATTITUDE_H
#define ESTIMATION_ATTITUDE_H

#include <stdbool.h>

#include "estimation/rotation.h"

/// What was measured in this step, in body axes; the flag of a value that was not measured is false.
typedef struct
{
    vector_t rate_rad_s;
    bool has_rate;
    vector_t force_m_s2; ///< specific force: 0, 0, -9.8 at rest and level
    bool has_force;
    vector_t field; ///< magnetic field of the earth, in any unit
    bool has_field;
    float airspeed_m_s; ///< true
    bool has_airspeed;
} attitude_input_t;

typedef struct
{
    rotation_t body; ///< to earth axes, north magnetic
    bool has_tilt;
    bool has_heading;
    vector_t bias_rad_s;
    vector_t rate_rad_s;     ///< of the body, without bias
    float without_rate_s;    ///< since the last gyro sample
    float airspeed_m_s;      ///< the last one measured; 0 before
    float slow_airspeed_m_s; ///< low-pass filtered; the difference to `airspeed_m_s` gives the acceleration
    bool has_airspeed;
    float airspeed_age_s;     ///< how long it has been measured, 2 s at most
    float compass_turn_rad_s; ///< rate of turn by the compass, used while the gyro is silent
    float urgency;            ///< 0: trust the gyro; 1: it cannot be trusted, follow gravity and compass
    float disagreed_s;        ///< how long gravity or compass has been far from the estimate
    float age_s;              ///< time since the attitude became known, for the first time or again
    vector_t down_sum;        ///< sum over the samples of the alignment
    int down_count;
} attitude_filter_t;

void attitude_init(attitude_filter_t* filter);

/// One step of `dt_s` (> 0). The first samples of gravity and compass align the filter.
void attitude_update(attitude_filter_t* filter, const attitude_input_t* input, float dt_s);

/// Whether the gyro has been heard in the last tenth of a second.
bool attitude_has_rate(const attitude_filter_t* filter);

#endif
