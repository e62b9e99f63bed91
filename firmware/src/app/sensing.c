#include "app/sensing.h"

#include <math.h>

#include "common/units.h"

/// NaN means that a sensor did not measure; it does not count as a bad sample.
static estimator_samples_t samples_of(const sensors_reading_t* reading)
{
    const message_inertial_t* const inertial = &reading->inertial;
    const message_analog_t* const analog = &reading->analog;
    return (estimator_samples_t){
        .gyro_rad_s = {inertial->gx_rad_s, inertial->gy_rad_s, inertial->gz_rad_s},
        .accelerometer_m_s2 = {inertial->accx_m_s2, inertial->accy_m_s2, inertial->accz_m_s2},
        .magnetometer = {inertial->magx, inertial->magy, inertial->magz},
        .static_pa = analog->baro_hpa * PA_PER_HPA,
        .pitot_pa = analog->pitot_pa,
        .is_measured =
            {
                [estimator_gyro] = !isnan(inertial->gx_rad_s),
                [estimator_accelerometer] = !isnan(inertial->accx_m_s2),
                [estimator_magnetometer] = !isnan(inertial->magx),
                [estimator_static_pressure] = !isnan(analog->baro_hpa),
                [estimator_pitot] = !isnan(analog->pitot_pa),
            },
    };
}

void sensing_update(estimator_t* estimator, const sensors_reading_t* reading, float dt_s, board_sensors_t* sensors)
{
    if (reading->gps.valid == 'A')
    {
        estimator_locate(estimator, reading->gps.latitude_deg, reading->gps.longitude_deg);
    }
    const estimator_samples_t samples = samples_of(reading);
    const estimate_t estimate = estimator_update(estimator, &samples, dt_s);
    sensors->ahrs = (message_ahrs_t){
        .yaw_deg = estimate.attitude.yaw_deg,
        .pitch_deg = estimate.attitude.pitch_deg,
        .roll_deg = estimate.attitude.roll_deg,
    };
    sensors->inertial = reading->inertial;
    sensors->inertial.gx_rad_s = estimate.rate_rad_s[0];
    sensors->inertial.gy_rad_s = estimate.rate_rad_s[1];
    sensors->inertial.gz_rad_s = estimate.rate_rad_s[2];
    sensors->analog = reading->analog;
    sensors->analog.altitude_m = estimate.altitude_m;
    sensors->analog.calibrated_airspeed_kt = estimate.calibrated_airspeed_m_s / M_S_PER_KT;
    sensors->analog.vvi_ft_min = estimate.vertical_speed_m_s / M_S_PER_FT_MIN;
    sensors->gps = reading->gps;
    sensors->servos_in = reading->receiver;
}
