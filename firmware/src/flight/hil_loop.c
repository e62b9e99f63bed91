#include "flight/hil_loop.h"

#include <math.h>
#include <string.h>

#include "common/limit.h"
#include "common/units.h"
#include "navigation/geodesy.h"

// Line and station make the arrivals irregular; the laws are not made for steps outside of these.
static const float step_minimum_s = 0.005F;
static const float step_maximum_s = 0.2F;
static const uint32_t pause_ms = 500;    ///< a longer gap counts as a pause of the simulator
static const float jump_m = 500.0F;      ///< no aircraft flies so far in one frame
static const float fastest_ratio = 2.0F; ///< of ground speed or climb to the indicated airspeed, in wind and up high

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

bool hil_loop_repeats(const command_xplane_info_t* before, const command_xplane_info_t* info)
{
    // below flying speed nothing is integrated, and a parked aircraft does stand still
    return info->speed_kt >= control_loop_flying_speed_kt && info->gx_rad_s == before->gx_rad_s &&
           info->gy_rad_s == before->gy_rad_s && info->gz_rad_s == before->gz_rad_s &&
           info->yaw_deg == before->yaw_deg && info->pitch_deg == before->pitch_deg &&
           info->roll_deg == before->roll_deg && info->altitude_ft == before->altitude_ft &&
           info->vvi_ft_min == before->vvi_ft_min && info->speed_kt == before->speed_kt &&
           info->latitude_deg == before->latitude_deg && info->longitude_deg == before->longitude_deg;
}

/// Whether the aircraft cannot have flown from `before` to `info`: the simulator put it there.
static bool jumps(const command_xplane_info_t* before, const command_xplane_info_t* info, uint32_t elapsed_ms)
{
    const position_t from = {(double)before->latitude_deg, (double)before->longitude_deg};
    const position_t to = {(double)info->latitude_deg, (double)info->longitude_deg};
    const float way_m = hypotf(geodesy_distance_m(&from, &to), (info->altitude_ft - before->altitude_ft) * M_PER_FT);
    const float speed_m_s = fmaxf(before->speed_kt, 0.0F) * M_S_PER_KT;
    return way_m > jump_m + fastest_ratio * speed_m_s * (float)elapsed_ms / 1000.0F;
}

/// Time of this step. The first step, a repeat, and a step after a pause integrate nothing: nobody knows how long the
/// aircraft has flown with these surfaces then. A simulator that sends each of its pictures twice has its whole time.
static float step_time_s(const hil_loop_t* hil, bool repeats, uint32_t now_ms)
{
    if (repeats)
    {
        return 0.0F;
    }
    if (hil->period_s > 0.0F)
    {
        return hil->period_s;
    }
    const uint32_t elapsed_ms = now_ms - hil->moved_ms;
    if (!hil->has_newest || elapsed_ms > pause_ms)
    {
        return 0.0F;
    }
    return limit_to((float)elapsed_ms / 1000.0F, step_minimum_s, step_maximum_s);
}

/// Begin the loop anew if the aircraft was put elsewhere; its integrals are of another flight.
static void begin_after_jump(hil_loop_t* hil, const command_xplane_info_t* info, uint32_t now_ms)
{
    if (hil->has_newest && jumps(&hil->newest, info, now_ms - hil->arrived_ms))
    {
        control_loop_init(&hil->loop);
        hil->jumps++;
    }
}

bool hil_loop_step(hil_loop_t* hil, const measurements_t* measured, const control_loop_gains_t* gains, plan_t* plan,
                   const command_xplane_info_t* info, uint32_t now_ms)
{
    if (!is_plausible(info))
    {
        hil->refused++;
        hil->step_s = 0.0F;
        return false;
    }
    const bool repeats = hil->has_newest && hil_loop_repeats(&hil->newest, info);
    const float dt_s = step_time_s(hil, repeats, now_ms);
    begin_after_jump(hil, info, now_ms);
    hil->step_s = dt_s;
    hil->newest = *info;
    hil->has_newest = true;
    hil->arrived_ms = now_ms;
    hil->moved_ms = repeats ? hil->moved_ms : now_ms;
    hil->repeated += repeats ? 1U : 0U;
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
