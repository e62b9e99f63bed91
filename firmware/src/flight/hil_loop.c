#include "flight/hil_loop.h"

#include <math.h>
#include <string.h>

#include "common/limit.h"

// Line and station make the arrivals irregular; the laws are not made for steps outside of these.
static const float step_minimum_s = 0.005F;
static const float step_maximum_s = 0.2F;
static const uint32_t pause_ms = 500; ///< a longer gap counts as a pause of the simulator

void hil_loop_init(hil_loop_t* hil, float period_s)
{
    memset(hil, 0, sizeof *hil);
    control_loop_init(&hil->loop);
    hil->source = control_source_rc;
    hil->period_s = period_s;
}

void hil_loop_refresh_switches(hil_loop_t* hil, const measurements_t* measured)
{
    if (hil->source == control_source_rc)
    {
        hil->autopilot = measurements_autopilot(measured);
        hil->autotrim = measurements_autotrim(measured);
    }
}

static surfaces_t stick_of_station(const command_xplane_info_t* info)
{
    const surfaces_t stick = {
        .elevator = info->elevator, .aileron = info->aileron, .rudder = info->rudder, .throttle = info->throttle};
    return surfaces_in_limits(&stick);
}

control_loop_input_t hil_loop_input(const hil_loop_t* hil, const measurements_t* measured)
{
    const command_xplane_info_t* const info = &hil->newest;
    return (control_loop_input_t){
        .stick = hil->source == control_source_rc ? measurements_stick(measured) : stick_of_station(info),
        .p_rad_s = info->gx_rad_s,
        .q_rad_s = info->gy_rad_s,
        .r_rad_s = info->gz_rad_s,
        .direction_deg = info->yaw_deg,
        .pitch_deg = info->pitch_deg,
        .roll_deg = info->roll_deg,
        .altitude_ft = info->altitude_ft,
        .vvi_ft_min = info->vvi_ft_min,
        .speed_kt = info->speed_kt,
        .position =
            {
                .latitude_deg = hil->has_newest ? (double)info->latitude_deg : (double)NAN,
                .longitude_deg = (double)info->longitude_deg,
            },
        .source = (int32_t)hil->source,
        .autopilot = hil->autopilot,
        .autotrim = hil->autotrim,
    };
}

static bool is_plausible(const command_xplane_info_t* info)
{
    const float values[] = {
        info->elevator, info->aileron,    info->rudder,      info->throttle,  info->gx_rad_s,
        info->gy_rad_s, info->gz_rad_s,   info->yaw_deg,     info->pitch_deg, info->roll_deg,
        info->speed_kt, info->vvi_ft_min, info->altitude_ft,
    };
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++)
    {
        if (!isfinite(values[i]))
        {
            return false;
        }
    }
    const position_t position = {(double)info->latitude_deg, (double)info->longitude_deg};
    return position_is_valid(&position);
}

/// Time of this step. The first step and one after a pause integrate nothing: nobody knows how long the aircraft has
/// flown with these surfaces then.
static float step_time_s(const hil_loop_t* hil, uint32_t now_ms)
{
    if (hil->period_s > 0.0F)
    {
        return hil->period_s;
    }
    const uint32_t elapsed_ms = now_ms - hil->arrived_ms;
    if (!hil->has_newest || elapsed_ms > pause_ms)
    {
        return 0.0F;
    }
    return limit_to((float)elapsed_ms / 1000.0F, step_minimum_s, step_maximum_s);
}

bool hil_loop_step(hil_loop_t* hil, const measurements_t* measured, const control_loop_gains_t* gains, plan_t* plan,
                   const command_xplane_info_t* info, uint32_t now_ms)
{
    if (!is_plausible(info))
    {
        hil->refused++;
        return false;
    }
    const float dt_s = step_time_s(hil, now_ms);
    hil->newest = *info;
    hil->has_newest = true;
    hil->arrived_ms = now_ms;
    hil->accepted++;
    hil_loop_refresh_switches(hil, measured);
    const control_loop_input_t input = hil_loop_input(hil, measured);
    (void)control_loop_step(&hil->loop, gains, plan, &input, dt_s);
    return true;
}

void hil_loop_supervise(hil_loop_t* hil, uint32_t now_ms)
{
    const uint32_t silent_ms = now_ms - hil->arrived_ms;
    failsafe_t* const missing = &hil->missing;
    missing->lasted_s[failsafe_simulator_silent] = 0.0F;
    failsafe_note(missing, failsafe_simulator_silent, hil->has_newest, (float)silent_ms / 1000.0F);
    if (failsafe_action(missing, failsafe_simulator_silent, hil->autopilot) == failsafe_neutral_surfaces)
    {
        control_loop_override(&hil->loop, &failsafe_surfaces);
    }
}
