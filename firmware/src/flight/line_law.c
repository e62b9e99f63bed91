#include "flight/line_law.h"

#include <math.h>

#include "common/units.h"

static const float slowest_over_ground_m_s = 6.0F;
static const float fastest_ratio = 1.4F; ///< of the planned airspeed, against a head wind
// true over indicated airspeed grows by this share each foot, within 1 % up to 20,000 ft
static const float thinning_per_ft = 1.5e-5F;

void line_law_init(line_law_t* law)
{
    *law = (line_law_t){.is_slow = false};
    legs_init(&law->legs);
}

static float true_airspeed_m_s(const autopilot_input_t* state)
{
    return fmaxf(state->speed_kt, 0.0F) * M_S_PER_KT * expf(thinning_per_ft * state->altitude_ft);
}

static energy_input_t energy_input(const line_law_input_t* input)
{
    return (energy_input_t){
        .altitude_ft = input->state.altitude_ft,
        .vvi_ft_min = input->state.vvi_ft_min,
        .pitch_deg = input->state.pitch_deg,
        .roll_deg = input->state.roll_deg,
        .speed_kt = input->state.speed_kt,
        .rate_per_command_rad_s = input->rate_per_command_rad_s,
        .frozen = input->state.frozen,
    };
}

void line_law_engage(line_law_t* law, const line_law_input_t* input, float throttle)
{
    const energy_input_t state = energy_input(input);
    energy_engage(&law->energy, &state, throttle);
    line_follow_engage(&law->follow, input->state.roll_deg);
    legs_restart(&law->legs);
}

/// Faster than planned where the wind would leave less than a walking pace over the ground.
static float against_wind_kt(line_law_t* law, float planned_kt, float airspeed_m_s, float indicated_kt)
{
    const float ground_m_s = wind_ground_speed_m_s(&law->legs.wind, airspeed_m_s, law->target.course_deg);
    const float lack_kt = (slowest_over_ground_m_s - ground_m_s) / M_S_PER_KT;
    const float needed_kt = indicated_kt + lack_kt;
    law->is_slow = needed_kt > planned_kt;
    return law->is_slow ? fminf(needed_kt, fastest_ratio * planned_kt) : planned_kt;
}

void line_law_navigate(line_law_t* law, const line_gains_t* gains, plan_t* plan, const line_law_input_t* input,
                       autopilot_target_t* hold, float dt_s)
{
    const float airspeed_m_s = true_airspeed_m_s(&input->state);
    const legs_input_t place = {
        .position = input->position,
        .track_deg = input->state.track_deg,
        .airspeed_m_s = airspeed_m_s,
        .altitude_ft = input->state.altitude_ft,
        .bank_deg = gains->follow.bank_limit_deg,
        .roll_time_s = gains->roll_time_s,
    };
    legs_guidance_t guidance;
    if (!legs_update(&law->legs, plan, &place, dt_s, &guidance))
    {
        law->target = (line_follow_target_t){.course_deg = hold->course_deg};
        return;
    }
    law->target = (line_follow_target_t){
        .course_deg = guidance.course_deg,
        .right_m = guidance.right_m,
        .curvature_per_m = guidance.curvature_per_m,
    };
    *hold = (autopilot_target_t){
        .altitude_ft = guidance.altitude_ft,
        .course_deg = guidance.course_deg,
        .speed_kt = against_wind_kt(law, guidance.speed_kt, airspeed_m_s, input->state.speed_kt),
    };
}

control_command_t line_law_command(line_law_t* law, const line_gains_t* gains, const autopilot_target_t* hold,
                                   const line_law_input_t* input, float dt_s)
{
    law->ground_speed_m_s =
        wind_ground_speed_m_s(&law->legs.wind, true_airspeed_m_s(&input->state), input->state.track_deg);
    const line_follow_input_t over_ground = {
        .track_deg = input->state.track_deg,
        .ground_speed_m_s = law->ground_speed_m_s,
        .roll_deg = input->state.roll_deg,
        .frozen = input->state.frozen,
    };
    const energy_target_t target = {.altitude_ft = hold->altitude_ft, .speed_kt = hold->speed_kt};
    const energy_input_t state = energy_input(input);
    const energy_command_t energy = energy_update(&law->energy, &gains->energy, &target, &state, dt_s);
    return (control_command_t){
        .elevator = energy.elevator,
        .aileron = line_follow_update(&law->follow, &gains->follow, &law->target, &over_ground, dt_s),
        .rudder = 0.0F,
        .throttle = energy.throttle,
    };
}
