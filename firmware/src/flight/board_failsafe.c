#include "flight/board_failsafe.h"

#include <math.h>

#include "common/limit.h"

static const surfaces_t neutral = {0};

static surfaces_t neutral_with_throttle(void)
{
    surfaces_t surfaces = neutral;
    surfaces.throttle = failsafe_throttle;
    return surfaces;
}

static bool is_heard(const message_servos_in_t* receiver)
{
    for (size_t i = 0; i < sizeof receiver->channel / sizeof receiver->channel[0]; i++)
    {
        if (!isfinite(receiver->channel[i]))
        {
            return false;
        }
    }
    return true;
}

float board_failsafe_channel(const board_t* board, size_t channel)
{
    const float newest = board->sensors.servos_in.channel[channel];
    return isfinite(newest) ? newest : board->receiver_heard.channel[channel];
}

surfaces_t board_failsafe_rc_stick(const board_t* board)
{
    if (failsafe_action(&board->failsafe, failsafe_receiver_silent, false) == failsafe_lets_stick_go)
    {
        return neutral_with_throttle();
    }
    return (surfaces_t){
        .elevator = limit_to(board_failsafe_channel(board, rc_channel_elevator), -1.0F, 1.0F),
        .aileron = limit_to(board_failsafe_channel(board, rc_channel_aileron), -1.0F, 1.0F),
        .rudder = limit_to(board_failsafe_channel(board, rc_channel_rudder), -1.0F, 1.0F),
        .throttle = limit_to(board_failsafe_channel(board, rc_channel_throttle), 0.0F, 1.0F),
    };
}

void board_failsafe_note_sensors(board_t* board, float dt_s)
{
    const board_sensors_t* const sensors = &board->sensors;
    failsafe_t* const failsafe = &board->failsafe;
    const bool is_receiver_heard = is_heard(&sensors->servos_in);
    if (is_receiver_heard)
    {
        board->receiver_heard = sensors->servos_in;
    }
    const bool has_rates = isfinite(sensors->inertial.gx_rad_s) && isfinite(sensors->inertial.gy_rad_s) &&
                           isfinite(sensors->inertial.gz_rad_s);
    const bool has_fix = sensors->gps.valid == 'A';
    const bool has_direction = isfinite(sensors->ahrs.yaw_deg) || (has_fix && isfinite(sensors->gps.heading_deg));
    const bool has_attitude = isfinite(sensors->ahrs.pitch_deg) && isfinite(sensors->ahrs.roll_deg) && has_direction;
    const bool has_altitude = isfinite(sensors->analog.altitude_m) || (has_fix && isfinite(sensors->gps.altitude_m));
    failsafe_note(failsafe, failsafe_receiver_silent, !is_receiver_heard, dt_s);
    failsafe_note(failsafe, failsafe_rates_unknown, !has_rates, dt_s);
    failsafe_note(failsafe, failsafe_attitude_unknown, !has_attitude, dt_s);
    failsafe_note(failsafe, failsafe_altitude_unknown, !has_altitude, dt_s);
}

/// A stick flies without attitude and altitude, so what is not known of them counts as level.
static void fill_in(control_loop_input_t* input)
{
    float* const values[] = {&input->pitch_deg, &input->roll_deg, &input->direction_deg, &input->altitude_ft};
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++)
    {
        *values[i] = isfinite(*values[i]) ? *values[i] : 0.0F;
    }
}

void board_failsafe_fly(board_t* board, const control_loop_input_t* input, float dt_s)
{
    control_loop_t* const loop = &board->loops[board_plan_flight];
    control_loop_input_t seen = *input;
    bool does[failsafe_action_count] = {false};
    for (size_t cause = failsafe_receiver_silent; cause < failsafe_count; cause++)
    {
        does[failsafe_action(&board->failsafe, (failsafe_cause_t)cause, input->autopilot)] = true;
    }
    if (does[failsafe_neutral_surfaces])
    {
        const surfaces_t surfaces = neutral_with_throttle();
        control_loop_override(loop, &surfaces);
        return;
    }
    if (does[failsafe_goes_undamped])
    {
        control_loop_override(loop, &input->stick);
        return;
    }
    if (does[failsafe_keeps_altitude])
    {
        seen.altitude_ft = loop->hold.altitude_ft;
        seen.vvi_ft_min = 0.0F;
    }
    if (!seen.autopilot)
    {
        fill_in(&seen);
    }
    (void)control_loop_step(loop, &board->gains, &board->plans[board_plan_flight], &seen, dt_s);
}

void board_supervise_hil(board_t* board, uint32_t now_ms)
{
    const uint32_t silent_ms = now_ms - board->xplane_info_ms;
    failsafe_t* const failsafe = &board->failsafe;
    failsafe->lasted_s[failsafe_simulator_silent] = 0.0F;
    failsafe_note(failsafe, failsafe_simulator_silent, board->has_xplane_info, (float)silent_ms / 1000.0F);
    if (failsafe_action(failsafe, failsafe_simulator_silent, board->hil_autopilot) == failsafe_neutral_surfaces)
    {
        const surfaces_t surfaces = neutral_with_throttle();
        control_loop_override(&board->loops[board_plan_hil], &surfaces);
    }
}
