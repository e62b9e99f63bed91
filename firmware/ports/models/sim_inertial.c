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

static const float path_lag_s = 0.1F;
static const float gust_lag_s = 0.5F;
static const float jump_m_s2 = 50.0F; ///< more than that is no flight: the aircraft was put elsewhere, or paused

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

/// A vector in axes that are level and turned with the nose (ahead, aside, down) as seen in body axes.
static void tilt(const sim_truth_t* truth, const float level[3], float body[3])
{
    const float pitch_rad = angle_to_rad(truth->pitch_deg);
    const float roll_rad = angle_to_rad(truth->roll_deg);
    const float below = sinf(pitch_rad) * level[0] + cosf(pitch_rad) * level[2];
    body[0] = cosf(pitch_rad) * level[0] - sinf(pitch_rad) * level[2];
    body[1] = cosf(roll_rad) * level[1] + sinf(roll_rad) * below;
    body[2] = -sinf(roll_rad) * level[1] + cosf(roll_rad) * below;
}

/// A vector in north, east, down as seen in body axes.
static void to_body(const sim_truth_t* truth, const float ned[3], float body[3])
{
    const float yaw_rad = angle_to_rad(truth->yaw_deg);
    const float level[3] = {cosf(yaw_rad) * ned[0] + sinf(yaw_rad) * ned[1],
                            -sinf(yaw_rad) * ned[0] + cosf(yaw_rad) * ned[1], ned[2]};
    tilt(truth, level, body);
}

/// Acceleration of the path (ahead, aside, down) from its speed, direction and climb. Not from the body's rates: in
/// gusts the nose swings and the path does not.
static void follow_path(sim_inertial_t* model, const sim_truth_t* truth, float dt_s)
{
    const float turn_rad = angle_to_rad(angle_wrap_180(truth->yaw_deg - model->track_deg));
    const float now_m_s2[3] = {
        (truth->airspeed_m_s - model->airspeed_m_s) / dt_s,
        truth->airspeed_m_s * turn_rad / dt_s,
        (model->climb_m_s - truth->climb_m_s) / dt_s,
    };
    bool is_flown = model->has_path;
    for (int axis = 0; axis < 3; axis++)
    {
        is_flown = is_flown && fabsf(now_m_s2[axis]) < jump_m_s2;
    }
    // what the airspeed says of a gust is not the aircraft's own acceleration
    const float lag_s[3] = {gust_lag_s, path_lag_s, path_lag_s};
    for (int axis = 0; axis < 3; axis++)
    {
        float* const held = &model->acceleration_m_s2[axis];
        *held = sim_lag(*held, is_flown ? now_m_s2[axis] : 0.0F, lag_s[axis], dt_s);
    }
    model->airspeed_m_s = truth->airspeed_m_s;
    model->climb_m_s = truth->climb_m_s;
    model->track_deg = truth->yaw_deg;
    model->has_path = true;
}

/// Specific force: what an accelerometer feels, that is acceleration without gravity.
static void specific_force(sim_inertial_t* model, const sim_truth_t* truth, float dt_s, float force_m_s2[3])
{
    follow_path(model, truth, dt_s);
    const float level_m_s2[3] = {model->acceleration_m_s2[0], model->acceleration_m_s2[1],
                                 model->acceleration_m_s2[2] - gravity_m_s2};
    tilt(truth, level_m_s2, force_m_s2);
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
