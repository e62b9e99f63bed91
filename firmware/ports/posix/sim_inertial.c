#include "sim_inertial.h"

#include <math.h>
#include <string.h>

#include "common/angle.h"

static const float gravity_m_s2 = 9.80665F;

// Errors of a small MEMS unit after calibration.
static const float gyro_noise_rad_s = 0.002F;
static const float gyro_bias_rad_s = 0.003F;
static const float acc_noise_m_s2 = 0.05F;
static const float acc_bias_m_s2 = 0.03F;
static const float mag_noise = 0.005F;
static const float mag_bias = 0.01F;
static const float bias_time_s = 300.0F;

static const float filter_lag_s = 0.05F;
static const float filter_noise_deg = 0.05F;
static const float filter_drift_deg = 0.3F;
static const float filter_drift_time_s = 20.0F;
static const float acceleration_lag_s = 0.5F;

// The earth's magnetic field at Gran Canaria: 4 deg west of north, 38 deg down.
static const float declination_deg = -4.0F;
static const float inclination_deg = 38.0F;

void sim_inertial_init(sim_inertial_t* model, uint32_t seed)
{
    memset(model, 0, sizeof *model);
    sim_noise_init(&model->noise, seed);
    for (int axis = 0; axis < 3; axis++)
    {
        model->gyro_bias_rad_s[axis] = sim_noise_normal(&model->noise, gyro_bias_rad_s);
        model->acc_bias_m_s2[axis] = sim_noise_normal(&model->noise, acc_bias_m_s2);
        model->mag_bias[axis] = sim_noise_normal(&model->noise, mag_bias);
    }
}

/// A vector in north, east, down as seen in body axes.
static void to_body(const sim_truth_t* truth, const float ned[3], float body[3])
{
    const float yaw_rad = angle_to_rad(truth->yaw_deg);
    const float pitch_rad = angle_to_rad(truth->pitch_deg);
    const float roll_rad = angle_to_rad(truth->roll_deg);
    const float ahead = cosf(yaw_rad) * ned[0] + sinf(yaw_rad) * ned[1];
    const float aside = -sinf(yaw_rad) * ned[0] + cosf(yaw_rad) * ned[1];
    const float below = sinf(pitch_rad) * ahead + cosf(pitch_rad) * ned[2];
    body[0] = cosf(pitch_rad) * ahead - sinf(pitch_rad) * ned[2];
    body[1] = cosf(roll_rad) * aside + sinf(roll_rad) * below;
    body[2] = -sinf(roll_rad) * aside + cosf(roll_rad) * below;
}

/// Specific force: what an accelerometer feels, that is acceleration without gravity. The air is taken to come from
/// ahead, so turning and pitching bend the path as fast as the body turns.
static void specific_force(sim_inertial_t* model, const sim_truth_t* truth, float dt_s, float force_m_s2[3])
{
    const float speed_m_s = truth->airspeed_m_s;
    const float change_m_s2 = model->has_airspeed ? (speed_m_s - model->airspeed_m_s) / dt_s : 0.0F;
    model->acceleration_m_s2 = sim_lag(model->acceleration_m_s2, change_m_s2, acceleration_lag_s, dt_s);
    model->airspeed_m_s = speed_m_s;
    model->has_airspeed = true;
    const float down_m_s2[3] = {0.0F, 0.0F, gravity_m_s2};
    float gravity[3];
    to_body(truth, down_m_s2, gravity);
    force_m_s2[0] = model->acceleration_m_s2 - gravity[0];
    force_m_s2[1] = truth->r_rad_s * speed_m_s - gravity[1];
    force_m_s2[2] = -truth->q_rad_s * speed_m_s - gravity[2];
}

static float measure(sim_inertial_t* model, float value, float* bias, float bias_sigma, float noise_sigma, float dt_s)
{
    sim_noise_wander(&model->noise, bias, bias_sigma, bias_time_s, dt_s);
    return value + *bias + sim_noise_normal(&model->noise, noise_sigma);
}

/// The estimate follows the true attitude with a short lag, the short way round for angles that wrap.
static void estimate(sim_inertial_t* model, const sim_truth_t* truth, float dt_s, message_ahrs_t* ahrs)
{
    message_ahrs_t* const held = &model->estimate;
    if (!model->has_estimate)
    {
        *held = (message_ahrs_t){truth->yaw_deg, truth->pitch_deg, truth->roll_deg};
        model->has_estimate = true;
    }
    held->yaw_deg += sim_lag(0.0F, angle_wrap_180(truth->yaw_deg - held->yaw_deg), filter_lag_s, dt_s);
    held->pitch_deg = sim_lag(held->pitch_deg, truth->pitch_deg, filter_lag_s, dt_s);
    held->roll_deg += sim_lag(0.0F, angle_wrap_180(truth->roll_deg - held->roll_deg), filter_lag_s, dt_s);
    float error_deg[3];
    for (int axis = 0; axis < 3; axis++)
    {
        sim_noise_wander(&model->noise, &model->drift_deg[axis], filter_drift_deg, filter_drift_time_s, dt_s);
        error_deg[axis] = model->drift_deg[axis] + sim_noise_normal(&model->noise, filter_noise_deg);
    }
    ahrs->yaw_deg = angle_wrap_360(held->yaw_deg + error_deg[0]);
    ahrs->pitch_deg = fmaxf(-90.0F, fminf(90.0F, held->pitch_deg + error_deg[1]));
    ahrs->roll_deg = angle_wrap_180(held->roll_deg + error_deg[2]);
}

void sim_inertial_read(sim_inertial_t* model, const sim_truth_t* truth, float dt_s, message_inertial_t* inertial,
                       message_ahrs_t* ahrs)
{
    const float rates_rad_s[3] = {truth->p_rad_s, truth->q_rad_s, truth->r_rad_s};
    const float inclination_rad = angle_to_rad(inclination_deg);
    const float declination_rad = angle_to_rad(declination_deg);
    const float earth_field[3] = {cosf(inclination_rad) * cosf(declination_rad),
                                  cosf(inclination_rad) * sinf(declination_rad), sinf(inclination_rad)};
    float force_m_s2[3];
    float field[3];
    specific_force(model, truth, dt_s, force_m_s2);
    to_body(truth, earth_field, field);
    float gyro[3];
    for (int axis = 0; axis < 3; axis++)
    {
        gyro[axis] =
            measure(model, rates_rad_s[axis], &model->gyro_bias_rad_s[axis], gyro_bias_rad_s, gyro_noise_rad_s, dt_s);
        force_m_s2[axis] =
            measure(model, force_m_s2[axis], &model->acc_bias_m_s2[axis], acc_bias_m_s2, acc_noise_m_s2, dt_s);
        field[axis] = measure(model, field[axis], &model->mag_bias[axis], mag_bias, mag_noise, dt_s);
    }
    *inertial = (message_inertial_t){gyro[0],       gyro[1],  gyro[2],  force_m_s2[0], force_m_s2[1],
                                     force_m_s2[2], field[0], field[1], field[2]};
    estimate(model, truth, dt_s, ahrs);
}
