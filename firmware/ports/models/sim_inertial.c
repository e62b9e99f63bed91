#include "sim_inertial.h"

#include <math.h>
#include <string.h>

#include "common/angle.h"
#include "common/units.h"

// Errors of a small MEMS unit after calibration.
static const float gyro_noise_rad_s = 0.002F;
static const float gyro_bias_rad_s = 0.003F;
static const float acc_noise_m_s2 = 0.05F;
static const float acc_bias_m_s2 = 0.03F;
static const float mag_noise = 0.005F;
static const float mag_bias = 0.01F;
static const float bias_time_s = 300.0F;

static const float gyro_drift_rad_s = 0.002F; ///< difference between a cold and a warm board
static const float warm_time_s = 180.0F;

static const float path_lag_s = 0.1F;
static const float gust_lag_s = 0.5F;
static const float longest_silence_s = 0.1F; ///< without a change for longer, the path counts as straight
static const float jump_m_s2 = 50.0F; ///< flight has no larger one: the simulator moved the aircraft, or was paused

void sim_inertial_init(sim_inertial_t* model, uint32_t seed)
{
    memset(model, 0, sizeof *model);
    sim_noise_init(&model->noise, seed);
    for (int axis = 0; axis < 3; axis++)
    {
        model->gyro_bias_rad_s[axis] = sim_noise_normal(&model->noise, gyro_bias_rad_s);
        model->gyro_drift_rad_s[axis] = sim_noise_normal(&model->noise, gyro_drift_rad_s);
        model->acc_bias_m_s2[axis] = sim_noise_normal(&model->noise, acc_bias_m_s2);
        model->mag_bias[axis] = sim_noise_normal(&model->noise, mag_bias);
    }
}

/// Turn a vector from level axes along the heading (ahead, right, down) into body axes.
static void tilt(const sim_truth_t* truth, const float level[3], float body[3])
{
    const float pitch_rad = angle_to_rad(truth->pitch_deg);
    const float roll_rad = angle_to_rad(truth->roll_deg);
    const float below = sinf(pitch_rad) * level[0] + cosf(pitch_rad) * level[2];
    body[0] = cosf(pitch_rad) * level[0] - sinf(pitch_rad) * level[2];
    body[1] = cosf(roll_rad) * level[1] + sinf(roll_rad) * below;
    body[2] = -sinf(roll_rad) * level[1] + cosf(roll_rad) * below;
}

/// Turn a vector from earth axes (north, east, down) into body axes.
static void to_body(const sim_truth_t* truth, const float ned[3], float body[3])
{
    const float yaw_rad = angle_to_rad(truth->yaw_deg);
    const float level[3] = {cosf(yaw_rad) * ned[0] + sinf(yaw_rad) * ned[1],
                            -sinf(yaw_rad) * ned[0] + cosf(yaw_rad) * ned[1], ned[2]};
    tilt(truth, level, body);
}

/// Acceleration of the path (ahead, right, down) from the changes of its speed, direction and climb; not from the
/// body's rates, because in gusts the nose swings but the path does not. The simulator sends the path less often than
/// the sensors are read, so a change is divided by the time since the last change.
static void follow_path(sim_inertial_t* model, const sim_truth_t* truth, float dt_s)
{
    const float turn_rad = angle_to_rad(angle_wrap_180(truth->yaw_deg - model->track_deg));
    const float faster_m_s = truth->airspeed_m_s - model->airspeed_m_s;
    const float sinking_m_s = model->climb_m_s - truth->climb_m_s;
    model->path_age_s += dt_s;
    const bool is_told = fabsf(turn_rad) + fabsf(faster_m_s) + fabsf(sinking_m_s) > 0.0F;
    if (model->has_path && !is_told && model->path_age_s < longest_silence_s)
    {
        return;
    }
    const float told_s = model->path_age_s;
    const float now_m_s2[3] = {faster_m_s / told_s, truth->airspeed_m_s * turn_rad / told_s, sinking_m_s / told_s};
    bool is_flown = model->has_path;
    for (int axis = 0; axis < 3; axis++)
    {
        is_flown = is_flown && fabsf(now_m_s2[axis]) < jump_m_s2;
    }
    // a gust changes the airspeed without accelerating the aircraft, so the airspeed is smoothed more
    const float lag_s[3] = {gust_lag_s, path_lag_s, path_lag_s};
    for (int axis = 0; axis < 3; axis++)
    {
        float* const held = &model->acceleration_m_s2[axis];
        *held = sim_lag(*held, is_flown ? now_m_s2[axis] : 0.0F, lag_s[axis], told_s);
    }
    model->airspeed_m_s = truth->airspeed_m_s;
    model->climb_m_s = truth->climb_m_s;
    model->track_deg = truth->yaw_deg;
    model->path_age_s = 0.0F;
    model->has_path = true;
}

/// Specific force, which an accelerometer measures: acceleration minus gravity.
static void specific_force(sim_inertial_t* model, const sim_truth_t* truth, float dt_s, float force_m_s2[3])
{
    follow_path(model, truth, dt_s);
    const float level_m_s2[3] = {model->acceleration_m_s2[0], model->acceleration_m_s2[1],
                                 model->acceleration_m_s2[2] - GRAVITY_M_S2};
    tilt(truth, level_m_s2, force_m_s2);
}

static float measure(sim_inertial_t* model, float value, float* bias, float bias_sigma, float noise_sigma, float dt_s)
{
    sim_noise_wander(&model->noise, bias, bias_sigma, bias_time_s, dt_s);
    return value + *bias + sim_noise_normal(&model->noise, noise_sigma);
}

void sim_inertial_read(sim_inertial_t* model, const sim_truth_t* truth, float dt_s, message_inertial_t* inertial)
{
    const float rates_rad_s[3] = {truth->p_rad_s, truth->q_rad_s, truth->r_rad_s};
    magnetic_field_move(&model->magnetic, (float)truth->latitude_deg, (float)truth->longitude_deg);
    const vector_t field_nt = model->magnetic.field_nt;
    const float strength_nt = vector_length(field_nt);
    const float earth_field[3] = {field_nt.x / strength_nt, field_nt.y / strength_nt, field_nt.z / strength_nt};
    float force_m_s2[3];
    float field[3];
    specific_force(model, truth, dt_s, force_m_s2);
    to_body(truth, earth_field, field);
    float gyro[3];
    model->age_s = fminf(model->age_s + dt_s, 10.0F * warm_time_s);
    const float warmth = 1.0F - expf(-model->age_s / warm_time_s);
    for (int axis = 0; axis < 3; axis++)
    {
        gyro[axis] = measure(model, rates_rad_s[axis] + model->gyro_drift_rad_s[axis] * warmth,
                             &model->gyro_bias_rad_s[axis], gyro_bias_rad_s, gyro_noise_rad_s, dt_s);
        force_m_s2[axis] =
            measure(model, force_m_s2[axis], &model->acc_bias_m_s2[axis], acc_bias_m_s2, acc_noise_m_s2, dt_s);
        field[axis] = measure(model, field[axis], &model->mag_bias[axis], mag_bias, mag_noise, dt_s);
    }
    const message_inertial_t sampled = {gyro[0],       gyro[1],  gyro[2],  force_m_s2[0], force_m_s2[1],
                                        force_m_s2[2], field[0], field[1], field[2]};
    *inertial = model->has_sampled ? model->sampled : sampled;
    model->sampled = sampled;
    model->has_sampled = true;
}
