#include "flight/board_loops.h"

#include <math.h>

#include "common/limit.h"
#include "flight/board_failsafe.h"
#include "flight/board_reports.h"

static const float ft_per_m = 3.28084F;

// Arrivals are jittered by the line and the station; a step outside of this is not what the laws were made for.
static const float step_minimum_s = 0.005F;
static const float step_maximum_s = 0.2F;
static const uint32_t pause_ms = 500; ///< longer than that, the loop was interrupted

static bool is_switched_on(const board_t* board, size_t channel)
{
    return board_failsafe_channel(board, channel) > 0.0F;
}

bool board_flight_autopilot(const board_t* board)
{
    return is_switched_on(board, rc_channel_autopilot);
}

bool board_flight_autotrim(const board_t* board)
{
    return is_switched_on(board, rc_channel_autotrim);
}

void board_refresh_switches(board_t* board)
{
    if (board->source == board_source_rc)
    {
        board->hil_autopilot = board_flight_autopilot(board);
        board->hil_autotrim = board_flight_autotrim(board);
    }
}

static surfaces_t limited_stick(float elevator, float aileron, float rudder, float throttle)
{
    return (surfaces_t){
        .elevator = limit_to(elevator, -1.0F, 1.0F),
        .aileron = limit_to(aileron, -1.0F, 1.0F),
        .rudder = limit_to(rudder, -1.0F, 1.0F),
        .throttle = limit_to(throttle, 0.0F, 1.0F),
    };
}

control_loop_input_t board_hil_input(const board_t* board)
{
    const command_xplane_info_t* const info = &board->xplane_info;
    const surfaces_t stick = board->source == board_source_rc
                                 ? board_failsafe_rc_stick(board)
                                 : limited_stick(info->elevator, info->aileron, info->rudder, info->throttle);
    return (control_loop_input_t){
        .stick = stick,
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
                .latitude_deg = board->has_xplane_info ? (double)info->latitude_deg : (double)NAN,
                .longitude_deg = (double)info->longitude_deg,
            },
        .source = (int32_t)board->source,
        .autopilot = board->hil_autopilot,
        .autotrim = board->hil_autotrim,
    };
}

/// The chosen source, or the other one where the chosen one measures nothing; 0 without either.
static float first_measured(float chosen, float other)
{
    if (isfinite(chosen))
    {
        return chosen;
    }
    return isfinite(other) ? other : 0.0F;
}

control_loop_input_t board_flight_input(const board_t* board)
{
    const board_sensors_t* const sensors = &board->sensors;
    const bool has_fix = sensors->gps.valid == 'A';
    const float gps_speed_kt = has_fix ? sensors->gps.speed_kt : NAN;
    const float gps_altitude_m = has_fix ? sensors->gps.altitude_m : NAN;
    const float pitot_speed_kt = sensors->analog.calibrated_airspeed_kt;
    const float baro_altitude_m = sensors->analog.altitude_m;
    const float speed_kt = board->airspeed_source == COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_GPS
                               ? first_measured(gps_speed_kt, pitot_speed_kt)
                               : first_measured(pitot_speed_kt, gps_speed_kt);
    const float altitude_m = board->altitude_source == COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_GPS
                                 ? first_measured(gps_altitude_m, baro_altitude_m)
                                 : first_measured(baro_altitude_m, gps_altitude_m);
    return (control_loop_input_t){
        .stick = board_failsafe_rc_stick(board),
        .p_rad_s = sensors->inertial.gx_rad_s,
        .q_rad_s = sensors->inertial.gy_rad_s,
        .r_rad_s = sensors->inertial.gz_rad_s,
        .direction_deg = has_fix ? sensors->gps.heading_deg : sensors->ahrs.yaw_deg,
        .pitch_deg = sensors->ahrs.pitch_deg,
        .roll_deg = sensors->ahrs.roll_deg,
        .altitude_ft = altitude_m * ft_per_m,
        .vvi_ft_min = first_measured(sensors->analog.vvi_ft_min, 0.0F),
        .speed_kt = speed_kt,
        .position =
            {
                .latitude_deg = has_fix ? (double)sensors->gps.latitude_deg : (double)NAN,
                .longitude_deg = (double)sensors->gps.longitude_deg,
            },
        .source = (int32_t)board_source_rc,
        .autopilot = board_flight_autopilot(board),
        .autotrim = board_flight_autotrim(board),
    };
}

void board_flight_step(board_t* board, float dt_s)
{
    board_failsafe_note_sensors(board, dt_s);
    const control_loop_input_t input = board_flight_input(board);
    board_failsafe_fly(board, &input, dt_s);
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

/// Time of this step. The first one and one after a pause integrate nothing: how long the aircraft flew by these
/// surfaces is not known then.
static float step_time_s(const board_t* board, uint32_t now_ms)
{
    if (board->config.hil_period_s > 0.0F)
    {
        return board->config.hil_period_s;
    }
    const uint32_t elapsed_ms = now_ms - board->xplane_info_ms;
    if (!board->has_stepped || elapsed_ms > pause_ms)
    {
        return 0.0F;
    }
    return limit_to((float)elapsed_ms / 1000.0F, step_minimum_s, step_maximum_s);
}

command_result_t board_hil_step(board_t* board, const command_xplane_info_t* info, uint32_t now_ms)
{
    control_loop_t* const loop = &board->loops[board_plan_hil];
    if (!is_plausible(info))
    {
        board->xplane_info_refused++;
        board_report_surfaces(board, &loop->surfaces);
        return command_bad_value;
    }
    const float dt_s = step_time_s(board, now_ms);
    board->xplane_info = *info;
    board->has_xplane_info = true;
    board->xplane_info_ms = now_ms;
    board->xplane_info_count++;
    board->has_stepped = true;
    board_refresh_switches(board);
    const control_loop_input_t input = board_hil_input(board);
    const surfaces_t surfaces = control_loop_step(loop, &board->gains, &board->plans[board_plan_hil], &input, dt_s);
    board_report_surfaces(board, &surfaces);
    return command_done;
}
