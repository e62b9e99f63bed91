#include "control/energy.h"

#include <math.h>

#include "common/angle.h"
#include "common/limit.h"
#include "common/units.h"

static const float pitch_minimum_deg = -20.0F;
static const float pitch_maximum_deg = 15.0F;
static const float trim_limit_deg = 12.0F;
static const float slowest_m_s = 10.0F;
static const float acceleration_limit_m_s2 = 1.5F;
static const float acceleration_smoothing_s = 0.5F;
static const float lack_smoothing_s = 1.5F;
static const float lack_allowed_kt = 5.0F;    ///< more, with the throttle at its end: the climb has to give
static const float climb_per_lack_m_s = 0.5F; ///< for each kt beyond
static const float climb_change_m_s2 = 4.0F;  ///< how quickly the wanted climb may change
// slow enough that a new target moves no surface by a twentieth of its travel in one step
static const float pitch_rate_limit_deg_s = 40.0F;
static const float throttle_rate_limit_per_s = 1.0F;
static const float steepest_roll_deg = 60.0F;

void energy_engage(energy_state_t* state, const energy_input_t* input, float throttle)
{
    const float speed_m_s = fmaxf(input->speed_kt * M_S_PER_KT, slowest_m_s);
    const float climb_m_s = input->vvi_ft_min * M_S_PER_FT_MIN;
    const float path_deg = angle_to_deg(asinf(limit_to(climb_m_s / speed_m_s, -1.0F, 1.0F)));
    *state = (energy_state_t){
        .pitch_trim_deg = limit_to(input->pitch_deg - path_deg, -trim_limit_deg, trim_limit_deg),
        .pitch_d_deg = input->pitch_deg,
        .climb_d_m_s = climb_m_s,
        .throttle_trim = limit_to(throttle, 0.0F, 1.0F),
        .throttle = limit_to(throttle, 0.0F, 1.0F),
        .speed_m_s = input->speed_kt * M_S_PER_KT,
    };
}

static float approach(float value, float wanted, float step)
{
    return limit_to(wanted, value - step, value + step);
}

/// Share that a first-order filter of time `time_s` takes over in `dt_s`.
static float share(float dt_s, float time_s)
{
    return dt_s / (time_s + dt_s);
}

static void note_speed(energy_state_t* state, const energy_target_t* target, const energy_input_t* input, float dt_s)
{
    const float speed_m_s = input->speed_kt * M_S_PER_KT;
    const float taken = share(dt_s, acceleration_smoothing_s);
    state->acceleration_m_s2 = (speed_m_s - state->speed_m_s) / (acceleration_smoothing_s + dt_s);
    state->speed_m_s += taken * (speed_m_s - state->speed_m_s);
    state->lack_kt += share(dt_s, lack_smoothing_s) * (target->speed_kt - input->speed_kt - state->lack_kt);
}

static float wanted_climb_m_s(energy_state_t* state, const energy_gains_t* gains, const energy_target_t* target,
                              const energy_input_t* input, float dt_s)
{
    const float error_m = (target->altitude_ft - input->altitude_ft) * M_PER_FT;
    const float wanted_m_s = limit_to(gains->k_climb_per_s * error_m, -gains->sink_limit_ft_min * M_S_PER_FT_MIN,
                                      gains->climb_limit_ft_min * M_S_PER_FT_MIN);
    float given_up_m_s = 0.0F;
    if (state->throttle >= 1.0F && state->lack_kt > lack_allowed_kt)
    {
        given_up_m_s = climb_per_lack_m_s * (state->lack_kt - lack_allowed_kt);
    }
    else if (state->throttle <= 0.0F && state->lack_kt < -lack_allowed_kt)
    {
        given_up_m_s = climb_per_lack_m_s * (state->lack_kt + lack_allowed_kt);
    }
    state->is_limited = given_up_m_s != 0.0F;
    state->climb_d_m_s = approach(state->climb_d_m_s, wanted_m_s - given_up_m_s, climb_change_m_s2 * dt_s);
    return state->climb_d_m_s;
}

static float elevator_of(energy_state_t* state, const energy_gains_t* gains, const energy_input_t* input,
                         float climb_d_m_s, float dt_s)
{
    const float speed_m_s = fmaxf(input->speed_kt * M_S_PER_KT, slowest_m_s);
    const float climb_m_s = input->vvi_ft_min * M_S_PER_FT_MIN;
    const float path_d_deg = angle_to_deg(climb_d_m_s / speed_m_s);
    const float error_deg = angle_to_deg((climb_d_m_s - climb_m_s) / speed_m_s);
    if (!input->frozen)
    {
        state->pitch_trim_deg = limit_to(state->pitch_trim_deg + gains->k_int_path_per_s * error_deg * dt_s,
                                         -trim_limit_deg, trim_limit_deg);
    }
    const float wanted_deg =
        limit_to(state->pitch_trim_deg + path_d_deg + gains->k_path * error_deg, pitch_minimum_deg, pitch_maximum_deg);
    state->pitch_d_deg = approach(state->pitch_d_deg, wanted_deg, pitch_rate_limit_deg_s * dt_s);
    const float roll_rad = angle_to_rad(limit_to(input->roll_deg, -steepest_roll_deg, steepest_roll_deg));
    const float turn_rad_s = GRAVITY_M_S2 / speed_m_s * tanf(roll_rad) * sinf(roll_rad);
    const float rate_limit_rad_s = gains->load_limit_g * GRAVITY_M_S2 / speed_m_s;
    const float scale_rad_s = fmaxf(input->rate_per_command_rad_s, 0.1F);
    const float limit = rate_limit_rad_s / scale_rad_s;
    const float command = gains->k_pitch * angle_to_rad(state->pitch_d_deg - input->pitch_deg);
    return limit_to(command, -limit, limit) + turn_rad_s / scale_rad_s;
}

static float throttle_of(energy_state_t* state, const energy_gains_t* gains, const energy_target_t* target,
                         const energy_input_t* input, float climb_d_m_s, float dt_s)
{
    const float speed_m_s = input->speed_kt * M_S_PER_KT;
    const float acceleration_d_m_s2 = limit_to(gains->k_accelerate_per_s * (target->speed_kt * M_S_PER_KT - speed_m_s),
                                               -acceleration_limit_m_s2, acceleration_limit_m_s2);
    const float wanted_m_s = climb_d_m_s + speed_m_s * acceleration_d_m_s2 / GRAVITY_M_S2;
    const float flown_m_s = input->vvi_ft_min * M_S_PER_FT_MIN + speed_m_s * state->acceleration_m_s2 / GRAVITY_M_S2;
    const float error_m_s = wanted_m_s - flown_m_s;
    if (!input->frozen)
    {
        state->throttle_trim =
            limit_to(state->throttle_trim + gains->k_int_energy_per_m * error_m_s * dt_s, 0.0F, 1.0F);
    }
    const float wanted = limit_to(
        state->throttle_trim + gains->k_feed_s_per_m * wanted_m_s + gains->k_energy_s_per_m * error_m_s, 0.0F, 1.0F);
    state->throttle = approach(state->throttle, wanted, throttle_rate_limit_per_s * dt_s);
    return state->throttle;
}

energy_command_t energy_update(energy_state_t* state, const energy_gains_t* gains, const energy_target_t* target,
                               const energy_input_t* input, float dt_s)
{
    note_speed(state, target, input, dt_s);
    const float climb_d_m_s = wanted_climb_m_s(state, gains, target, input, dt_s);
    return (energy_command_t){
        .elevator = elevator_of(state, gains, input, climb_d_m_s, dt_s),
        .throttle = throttle_of(state, gains, target, input, climb_d_m_s, dt_s),
    };
}
