/// The board's own estimate of its state from the samples of its sensors: the one entry to this folder.
///
/// Samples come in the sensors' units; the flag of a sensor that measured nothing in a step is false. A sample that
/// is not finite or not plausible is refused, counted, and treated as missing.
#ifndef ESTIMATION_ESTIMATOR_H
#define ESTIMATION_ESTIMATOR_H

#include <stdbool.h>
#include <stdint.h>

#include "estimation/attitude.h"
#include "estimation/magnetic_field.h"
#include "estimation/vertical.h"

typedef enum
{
    estimator_gyro,
    estimator_accelerometer,
    estimator_magnetometer,
    estimator_static_pressure,
    estimator_pitot,
    estimator_sensor_count
} estimator_sensor_t;

/// Body axes: x ahead, y right, z down; rates by the right hand (roll right, nose up, nose right are positive).
typedef struct
{
    float gyro_rad_s[3];
    float accelerometer_m_s2[3]; ///< specific force: 0, 0, -9.8 at rest and level
    float magnetometer[3];       ///< the earth's field has a length of about 1
    float static_pa;
    float pitot_pa; ///< above the static pressure
    bool is_measured[estimator_sensor_count];
} estimator_samples_t;

/// NaN: not known yet, or not known any more.
typedef struct
{
    euler_t attitude;         ///< heading true
    float rate_rad_s[3];      ///< of the body, without the gyro's bias
    float altitude_m;         ///< pressure altitude
    float vertical_speed_m_s; ///< climb is positive
    float calibrated_airspeed_m_s;
} estimate_t;

typedef struct
{
    magnetic_field_t magnetic; ///< where the aircraft flies
    attitude_filter_t attitude;
    vertical_filter_t vertical;
    float static_pa; ///< the last one; before the first, that at sea level
    float airspeed_m_s;
    float without_pitot_s;
    bool has_airspeed;
    uint32_t refused[estimator_sensor_count];
} estimator_t;

void estimator_init(estimator_t* estimator);

/// The aircraft's place in deg (north and east positive). The heading is true, so it is not known before the first
/// place that is finite and on the earth; a later one that is not leaves the last.
void estimator_locate(estimator_t* estimator, float latitude_deg, float longitude_deg);

/// One step of `dt_s` (> 0, at least 50 a second for an aircraft) and the estimate after it.
estimate_t estimator_update(estimator_t* estimator, const estimator_samples_t* samples, float dt_s);

#endif
