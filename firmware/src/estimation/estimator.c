#include "estimation/estimator.h"

#include <math.h>
#include <stddef.h>

#include "common/angle.h"
#include "common/limit.h"
#include "common/units.h"
#include "estimation/air.h"
#include "estimation/gravity.h"

static const float standard_pa = 101325.0F;
static const float longest_without_pitot_s = 1.0F;

/// Smallest and largest plausible value of each axis of a sample.
typedef struct
{
    float minimum;
    float maximum;
} range_t;

static const range_t ranges[estimator_sensor_count] = {
    [estimator_gyro] = {-35.0F, 35.0F},               // 2000 deg/s, the widest range of small gyros
    [estimator_accelerometer] = {-160.0F, 160.0F},    // 16 g
    [estimator_magnetometer] = {-2.0F, 2.0F},         // twice the earth's field
    [estimator_static_pressure] = {22632.0F, 1.1e5F}, // 11 km, up to where the formulas of the atmosphere hold
    [estimator_pitot] = {-2000.0F, 20000.0F},         // beyond 170 m/s
};

void estimator_init(estimator_t* estimator)
{
    *estimator = (estimator_t){.static_pa = standard_pa};
    attitude_init(&estimator->attitude);
    vertical_init(&estimator->vertical);
}

void estimator_locate(estimator_t* estimator, float latitude_deg, float longitude_deg)
{
    // written so that a NaN is refused
    if (fabsf(latitude_deg) <= 90.0F && fabsf(longitude_deg) <= 180.0F)
    {
        magnetic_field_move(&estimator->magnetic, latitude_deg, longitude_deg);
    }
}

/// Whether there is a plausible sample; an implausible one is counted.
static bool is_sound(estimator_t* estimator, const estimator_samples_t* samples, estimator_sensor_t sensor,
                     const float* values, size_t count)
{
    if (!samples->is_measured[sensor])
    {
        return false;
    }
    for (size_t i = 0; i < count; i++)
    {
        // written so that a NaN is refused
        if (!(values[i] >= ranges[sensor].minimum && values[i] <= ranges[sensor].maximum))
        {
            estimator->refused[sensor]++;
            return false;
        }
    }
    return true;
}

static vector_t vector_of(const float values[3])
{
    return (vector_t){values[0], values[1], values[2]};
}

static void note_airspeed(estimator_t* estimator, bool has_pitot, float pitot_pa, float dt_s)
{
    estimator->without_pitot_s = has_pitot ? 0.0F : estimator->without_pitot_s + dt_s;
    if (has_pitot)
    {
        estimator->airspeed_m_s = air_calibrated_speed_m_s(pitot_pa);
        estimator->has_airspeed = true;
    }
    else if (estimator->without_pitot_s > longest_without_pitot_s)
    {
        estimator->has_airspeed = false;
    }
}

static void update_attitude(estimator_t* estimator, const estimator_samples_t* samples, bool has_force, bool has_pitot,
                            float dt_s)
{
    const attitude_input_t input = {
        .rate_rad_s = vector_of(samples->gyro_rad_s),
        .has_rate = is_sound(estimator, samples, estimator_gyro, samples->gyro_rad_s, 3),
        .force_m_s2 = vector_of(samples->accelerometer_m_s2),
        .has_force = has_force,
        .field = vector_of(samples->magnetometer),
        .has_field = is_sound(estimator, samples, estimator_magnetometer, samples->magnetometer, 3),
        .airspeed_m_s = air_true_speed_m_s(fmaxf(0.0F, estimator->airspeed_m_s), estimator->static_pa),
        .has_airspeed = has_pitot,
    };
    attitude_update(&estimator->attitude, &input, dt_s);
}

static void update_vertical(estimator_t* estimator, const estimator_samples_t* samples, bool has_force, bool has_static,
                            float dt_s)
{
    const vector_t force = rotation_to_earth(estimator->attitude.body, vector_of(samples->accelerometer_m_s2));
    const vertical_input_t input = {
        .altitude_m = has_static ? air_altitude_m(samples->static_pa) : 0.0F,
        .has_altitude = has_static,
        .acceleration_m_s2 = -force.z - GRAVITY_M_S2,
        .has_acceleration = has_force && estimator->attitude.has_tilt,
    };
    vertical_update(&estimator->vertical, &input, dt_s);
}

static estimate_t estimated(const estimator_t* estimator)
{
    const attitude_filter_t* const attitude = &estimator->attitude;
    const bool is_vertical_known = vertical_is_known(&estimator->vertical);
    const bool has_rate = attitude->has_tilt && attitude_has_rate(attitude);
    const euler_t angles = rotation_to_euler(attitude->body);
    const float declination_deg = magnetic_field_declination_deg(&estimator->magnetic);
    return (estimate_t){
        .attitude =
            {
                .yaw_deg = attitude->has_heading ? angle_wrap_360(angles.yaw_deg + declination_deg) : NAN,
                .pitch_deg = attitude->has_tilt ? angles.pitch_deg : NAN,
                .roll_deg = attitude->has_tilt ? angles.roll_deg : NAN,
            },
        .rate_rad_s =
            {
                has_rate ? attitude->rate_rad_s.x : NAN,
                has_rate ? attitude->rate_rad_s.y : NAN,
                has_rate ? attitude->rate_rad_s.z : NAN,
            },
        .altitude_m = is_vertical_known ? estimator->vertical.altitude_m : NAN,
        .vertical_speed_m_s = is_vertical_known ? estimator->vertical.speed_m_s : NAN,
        .calibrated_airspeed_m_s = estimator->has_airspeed ? estimator->airspeed_m_s : NAN,
    };
}

estimate_t estimator_update(estimator_t* estimator, const estimator_samples_t* samples, float dt_s)
{
    const bool has_static = is_sound(estimator, samples, estimator_static_pressure, &samples->static_pa, 1);
    const bool has_pitot = is_sound(estimator, samples, estimator_pitot, &samples->pitot_pa, 1);
    const bool has_force = is_sound(estimator, samples, estimator_accelerometer, samples->accelerometer_m_s2, 3);
    estimator->static_pa = has_static ? samples->static_pa : estimator->static_pa;
    note_airspeed(estimator, has_pitot, samples->pitot_pa, dt_s);
    update_attitude(estimator, samples, has_force, has_pitot, dt_s);
    update_vertical(estimator, samples, has_force, has_static, dt_s);
    return estimated(estimator);
}
