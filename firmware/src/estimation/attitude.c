#include "estimation/attitude.h"

#include <math.h>

#include "common/angle.h"
#include "common/limit.h"
#include "estimation/gravity.h"

enum
{
    alignment_samples = 10
};

/// How fast an error is corrected.
typedef struct
{
    float slow_per_s;      ///< while the gyro is trusted: gusts and side-slip are averaged over 1 / this
    float fast_per_s;      ///< while the gyro is not trusted
    float bias_per_s2;     ///< of the gyro's bias
    float new_bias_per_s2; ///< added in the first seconds, while the bias is unknown
} gain_t;

static const gain_t tilt_gain = {0.15F, 2.0F, 0.004F, 0.1F};
static const gain_t heading_gain = {0.15F, 2.0F, 0.004F, 0.1F};

static const float new_for_s = 8.0F;
static const float urgent_for_s = 2.0F;  ///< after a silent gyro is heard again
static const float longest_gap_s = 0.1F; ///< up to this gap, the last rate is used on
static const float largest_bias_rad_s = 0.2F;
static const float airspeed_time_s = 0.5F;
static const float airspeed_new_for_s = 1.0F; ///< its first samples are noise: no acceleration is computed from them

// With less smoothing, the rate of turn from the compass, the tilt computed with that rate, and the heading computed
// with that tilt would drive each other into an oscillation.
static const float compass_turn_time_s = 2.0F;
static const float fastest_turn_rad_s = 1.0F;
static const float largest_acceleration_m_s2 = 5.0F;

// An estimate that is this far off is not explained by the gyro's drift: follow gravity and compass instead.
static const float far_rad = 0.35F;
static const float far_for_s = 1.0F;

/// Least horizontal share of the magnetic field; below it the field is so steep that the compass shows no north.
static const float least_horizontal = 0.1F;

void attitude_init(attitude_filter_t* filter)
{
    *filter = (attitude_filter_t){.body = {.w = 1.0F}, .urgency = 1.0F};
}

bool attitude_has_rate(const attitude_filter_t* filter)
{
    return filter->without_rate_s <= longest_gap_s;
}

static void turn_about_down(attitude_filter_t* filter, float angle_rad)
{
    const vector_t down = rotation_to_body(filter->body, (vector_t){.z = 1.0F});
    filter->body = rotation_turned(filter->body, vector_scaled(down, angle_rad));
}

static void note_airspeed(attitude_filter_t* filter, const attitude_input_t* input, float dt_s)
{
    if (!input->has_airspeed)
    {
        return; // keep the last airspeed: it is nearer to the truth than no airspeed
    }
    const float change_m_s = input->airspeed_m_s - filter->slow_airspeed_m_s;
    if (!filter->has_airspeed || fabsf(change_m_s) > largest_acceleration_m_s2 * airspeed_time_s)
    {
        // the first sample, a gust, or an aircraft that the simulator moved: no acceleration
        filter->slow_airspeed_m_s = input->airspeed_m_s;
        filter->has_airspeed = true;
    }
    filter->airspeed_m_s = input->airspeed_m_s;
    filter->airspeed_age_s = fminf(filter->airspeed_age_s + dt_s, 2.0F * airspeed_new_for_s);
    // The mean of the first samples, then a low-pass filter.
    const float share = fmaxf(1.0F - expf(-dt_s / airspeed_time_s), dt_s / filter->airspeed_age_s);
    filter->slow_airspeed_m_s += share * (filter->airspeed_m_s - filter->slow_airspeed_m_s);
}

static gravity_t felt(const attitude_filter_t* filter, const attitude_input_t* input)
{
    const bool is_settled = filter->airspeed_age_s >= airspeed_new_for_s;
    const float change_m_s2 = is_settled ? (filter->airspeed_m_s - filter->slow_airspeed_m_s) / airspeed_time_s : 0.0F;
    const gravity_input_t gravity = {
        .force_m_s2 = input->force_m_s2,
        .rate_rad_s = filter->rate_rad_s,
        .airspeed_m_s = filter->airspeed_m_s,
        .acceleration_m_s2 = change_m_s2,
    };
    return gravity_felt(&gravity);
}

/// Turn the estimate by the gyro, or about the vertical by the compass while the gyro is silent.
static void turn(attitude_filter_t* filter, const attitude_input_t* input, float dt_s)
{
    filter->without_rate_s = input->has_rate ? 0.0F : filter->without_rate_s + dt_s;
    const vector_t before = filter->rate_rad_s;
    if (input->has_rate)
    {
        filter->rate_rad_s = vector_difference(input->rate_rad_s, filter->bias_rad_s);
    }
    else if (!attitude_has_rate(filter))
    {
        const vector_t turning = {.z = filter->compass_turn_rad_s};
        filter->rate_rad_s = rotation_to_body(filter->body, turning);
    }
    // Each sample is the rate at one instant, so between two samples the mean rate applies.
    const vector_t mean = vector_scaled(vector_sum(before, filter->rate_rad_s), 0.5F);
    filter->body = rotation_turned(filter->body, vector_scaled(mean, dt_s));
}

/// Small rotation that would bring the estimated down to the measured one.
static vector_t tilt_error_rad(const attitude_filter_t* filter, vector_t down)
{
    const vector_t estimated = rotation_to_body(filter->body, (vector_t){.z = 1.0F});
    const vector_t error = vector_cross(down, estimated);
    const float length = vector_length(error);
    if (vector_dot(down, estimated) > 0.0F || length < 1e-3F)
    {
        return error;
    }
    return vector_scaled(error, 1.0F / length); // beyond a right angle the product would become smaller again
}

/// Heading by the compass, corrected for tilt, minus the estimated heading; false where the field shows no north.
static bool heading_error_rad(const attitude_filter_t* filter, vector_t field, float* error_rad)
{
    const vector_t levelled = rotation_to_earth(filter->body, field);
    const float horizontal = sqrtf(levelled.x * levelled.x + levelled.y * levelled.y);
    if (!(horizontal > least_horizontal * vector_length(field)))
    {
        return false;
    }
    const float azimuth_deg = angle_to_deg(atan2f(levelled.y, levelled.x));
    *error_rad = angle_to_rad(angle_wrap_180(-azimuth_deg));
    return true;
}

/// Turn the estimate by the share of `error_rad` (body axes) that gain and `trust` allow, and correct the bias by it.
static void correct(attitude_filter_t* filter, const gain_t* gain, vector_t error_rad, float trust, float dt_s)
{
    const float per_s = gain->slow_per_s + (gain->fast_per_s - gain->slow_per_s) * filter->urgency;
    filter->body = rotation_turned(filter->body, vector_scaled(error_rad, limit_to(trust * per_s * dt_s, 0.0F, 1.0F)));
    // After a gap, or when the simulator moved the aircraft, the error does not come from the bias.
    const float newness = expf(-filter->age_s / new_for_s);
    const float learning = (1.0F - filter->urgency) * (gain->bias_per_s2 + gain->new_bias_per_s2 * newness);
    if (attitude_has_rate(filter))
    {
        const vector_t step = vector_scaled(error_rad, trust * learning * dt_s);
        filter->bias_rad_s.x = limit_to(filter->bias_rad_s.x - step.x, -largest_bias_rad_s, largest_bias_rad_s);
        filter->bias_rad_s.y = limit_to(filter->bias_rad_s.y - step.y, -largest_bias_rad_s, largest_bias_rad_s);
        filter->bias_rad_s.z = limit_to(filter->bias_rad_s.z - step.z, -largest_bias_rad_s, largest_bias_rad_s);
    }
}

/// Tilt from the mean of the first samples.
static void align(attitude_filter_t* filter, const gravity_t* gravity)
{
    filter->down_sum = vector_sum(filter->down_sum, vector_scaled(gravity->down, gravity->trust));
    filter->down_count += gravity->trust > 0.0F ? 1 : 0;
    const float length = vector_length(filter->down_sum);
    if (filter->down_count < alignment_samples || length < 1e-3F)
    {
        return;
    }
    const vector_t down = vector_scaled(filter->down_sum, 1.0F / length);
    filter->body = rotation_from_euler((euler_t){
        .pitch_deg = angle_to_deg(asinf(limit_to(-down.x, -1.0F, 1.0F))),
        .roll_deg = angle_to_deg(atan2f(down.y, down.z)),
    });
    filter->has_tilt = true;
}

static float correct_tilt(attitude_filter_t* filter, const gravity_t* gravity, float dt_s)
{
    const vector_t error_rad = tilt_error_rad(filter, gravity->down);
    correct(filter, &tilt_gain, error_rad, gravity->trust, dt_s);
    return gravity->trust > 0.0F ? vector_length(error_rad) : 0.0F;
}

static float correct_heading(attitude_filter_t* filter, vector_t field, float dt_s)
{
    float error_rad = 0.0F;
    if (!heading_error_rad(filter, field, &error_rad))
    {
        return 0.0F;
    }
    if (!filter->has_heading)
    {
        turn_about_down(filter, error_rad);
        filter->has_heading = true;
        return 0.0F;
    }
    const vector_t down = rotation_to_body(filter->body, (vector_t){.z = 1.0F});
    correct(filter, &heading_gain, vector_scaled(down, error_rad), 1.0F, dt_s);
    return fabsf(error_rad);
}

/// Smoothed rate of turn of the heading: from the gyro while it measures, so that there is a value to begin with, and
/// from the compass once the gyro is silent. Without either, the turn is assumed to end.
static void note_turn(attitude_filter_t* filter, float heading_before_deg, bool is_measured, float dt_s)
{
    const float heading_deg = rotation_to_euler(filter->body).yaw_deg;
    const float seen_rad_s = angle_to_rad(angle_wrap_180(heading_deg - heading_before_deg)) / dt_s;
    const float rate_rad_s = is_measured ? limit_to(seen_rad_s, -fastest_turn_rad_s, fastest_turn_rad_s) : 0.0F;
    const float share = 1.0F - expf(-dt_s / compass_turn_time_s);
    filter->compass_turn_rad_s += share * (rate_rad_s - filter->compass_turn_rad_s);
}

static void judge(attitude_filter_t* filter, float error_rad, float dt_s)
{
    filter->disagreed_s = error_rad > far_rad ? filter->disagreed_s + dt_s : 0.0F;
    if (!attitude_has_rate(filter))
    {
        filter->urgency = 1.0F;
        return;
    }
    if (filter->disagreed_s >= far_for_s)
    {
        filter->urgency = 1.0F;
        filter->age_s = 0.0F; // the bias may be as wrong as the attitude: estimate it anew
        return;
    }
    filter->urgency *= expf(-dt_s / urgent_for_s);
}

void attitude_update(attitude_filter_t* filter, const attitude_input_t* input, float dt_s)
{
    note_airspeed(filter, input, dt_s);
    if (!filter->has_tilt)
    {
        filter->rate_rad_s = input->has_rate ? input->rate_rad_s : (vector_t){0};
        if (input->has_force)
        {
            const gravity_t gravity = felt(filter, input);
            align(filter, &gravity);
        }
        return;
    }
    const float heading_before_deg = rotation_to_euler(filter->body).yaw_deg;
    float error_rad = 0.0F;
    turn(filter, input, dt_s);
    if (input->has_force)
    {
        const gravity_t gravity = felt(filter, input);
        error_rad = correct_tilt(filter, &gravity, dt_s);
    }
    if (input->has_field)
    {
        error_rad = fmaxf(error_rad, correct_heading(filter, input->field, dt_s));
    }
    note_turn(filter, heading_before_deg, input->has_rate || input->has_field, dt_s);
    judge(filter, error_rad, dt_s);
    filter->age_s += dt_s;
}
