#include "flight/control_loop.h"

#include <math.h>

enum
{
    no_source = -1 ///< differs from the source of every input, so that the next step is a change of source
};

static const float ground_band_ft = 10.0F; ///< an aircraft this far above or below the ground is in the air
static const float ground_run_limit_s = 20.0F;

const float control_loop_flying_speed_kt = 20.0F;

void control_loop_init(control_loop_t* loop)
{
    *loop = (control_loop_t){.has_run = false};
    transition_init(&loop->transition);
    track_init(&loop->track);
    line_law_init(&loop->line);
}

static bool is_finite_input(const control_loop_input_t* input)
{
    const float values[] = {
        input->stick.elevator, input->stick.aileron, input->stick.rudder,  input->stick.throttle, input->p_rad_s,
        input->q_rad_s,        input->r_rad_s,       input->direction_deg, input->pitch_deg,      input->roll_deg,
        input->altitude_ft,    input->vvi_ft_min,    input->speed_kt,
    };
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++)
    {
        if (!isfinite(values[i]))
        {
            return false;
        }
    }
    return true;
}

/// True while the integrals must not change: below flying speed, or during the take-off run. No sensor tells whether
/// the wheels touch the ground, so the altitude where the aircraft last was below flying speed counts as the ground.
/// The run has a time limit, because an aircraft that was slow in the air must soon count as flying again.
static bool is_frozen(control_loop_t* loop, const control_loop_input_t* input, float dt_s)
{
    if (input->speed_kt < control_loop_flying_speed_kt)
    {
        loop->ground_altitude_ft = input->altitude_ft;
        loop->ground_is_known = true;
        loop->ground_run_s = 0.0F;
        return true;
    }
    loop->ground_run_s += dt_s;
    if (fabsf(input->altitude_ft - loop->ground_altitude_ft) > ground_band_ft ||
        loop->ground_run_s > ground_run_limit_s)
    {
        loop->ground_is_known = false;
    }
    return loop->ground_is_known;
}

/// A step without time adds nothing to the means that the drift is found from: a minute of a frozen heading would
/// outweigh the flight. The very first step has no time either and begins them.
static float find_track_deg(control_loop_t* loop, const control_loop_input_t* input, float dt_s)
{
    if (loop->has_run && !(dt_s > 0.0F))
    {
        return track_direction_deg(&loop->track, input->direction_deg);
    }
    return track_update(&loop->track, &input->position, input->direction_deg, input->speed_kt);
}

/// The autopilot's target: from the plan, or without one the altitude, course and speed when it was switched on. It is
/// kept, to be held if the position is lost.
static void choose_target(control_loop_t* loop, const control_loop_gains_t* gains, plan_t* plan,
                          const control_loop_input_t* input, const line_law_input_t* state, float dt_s)
{
    plan_guidance_t guidance;
    if (plan->count > 0 && position_is_valid(&input->position))
    {
        if (gains->law == guidance_law_bearing && plan_update(plan, &input->position, input->speed_kt, &guidance))
        {
            loop->hold = (autopilot_target_t){
                .altitude_ft = guidance.altitude_ft,
                .course_deg = guidance.course_deg,
                .speed_kt = guidance.speed_kt,
            };
        }
    }
    else if (!loop->autopilot_was_on)
    {
        loop->hold = (autopilot_target_t){
            .altitude_ft = input->altitude_ft,
            .course_deg = state->state.track_deg,
            .speed_kt = input->speed_kt,
        };
    }
    if (gains->law == guidance_law_line)
    {
        line_law_navigate(&loop->line, &gains->line, plan, state, &loop->hold, dt_s);
    }
}

/// Whether the source of the commands differs from that of the last step: stick, autopilot, its law, or autotrim.
static bool has_changed_hands(const control_loop_t* loop, const control_loop_gains_t* gains,
                              const control_loop_input_t* input)
{
    return loop->has_run && (loop->autopilot_was_on != input->autopilot || loop->autotrim_was_on != input->autotrim ||
                             loop->source != input->source || loop->law != gains->law);
}

/// Fly-by-wire of this moment: the line law brings a yaw damper of its own.
static fly_by_wire_gains_t rate_gains(const control_loop_gains_t* gains, bool autopilot)
{
    fly_by_wire_gains_t rates = gains->fly_by_wire;
    if (autopilot && gains->law == guidance_law_line)
    {
        rates.k_rudder = gains->line.k_rudder;
    }
    return rates;
}

static control_command_t command_of_law(control_loop_t* loop, const control_loop_gains_t* gains,
                                        const line_law_input_t* state, bool engages, float throttle, float dt_s)
{
    if (gains->law == guidance_law_line)
    {
        if (engages)
        {
            line_law_engage(&loop->line, state, throttle);
        }
        return line_law_command(&loop->line, &gains->line, &loop->hold, state, dt_s);
    }
    if (engages)
    {
        autopilot_engage(&loop->autopilot, &state->state, throttle);
    }
    return autopilot_update(&loop->autopilot, &gains->autopilot, &loop->hold, &state->state, dt_s);
}

static control_command_t command_of_autopilot(control_loop_t* loop, const control_loop_gains_t* gains,
                                              const control_loop_input_t* input, const line_law_input_t* state,
                                              const fly_by_wire_input_t* rates, float dt_s)
{
    const bool engages = !loop->autopilot_was_on || loop->law != gains->law;
    const float throttle = loop->has_run ? loop->surfaces.throttle : input->stick.throttle;
    const control_command_t command = command_of_law(loop, gains, state, engages, throttle, dt_s);
    if (engages && loop->has_run)
    {
        fly_by_wire_hold_elevator(&loop->fly_by_wire, &gains->fly_by_wire, &command, rates, loop->surfaces.elevator);
    }
    return command;
}

void control_loop_override(control_loop_t* loop, const surfaces_t* surfaces)
{
    loop->surfaces = surfaces_in_limits(surfaces);
    transition_init(&loop->transition);
    loop->source = no_source;
    loop->autopilot_was_on = false;
    loop->has_run = true;
}

surfaces_t control_loop_step(control_loop_t* loop, const control_loop_gains_t* gains, plan_t* plan,
                             const control_loop_input_t* input, float dt_s)
{
    if (!is_finite_input(input))
    {
        return loop->surfaces;
    }
    const float track_deg = find_track_deg(loop, input, dt_s);
    const fly_by_wire_input_t rates = {
        .p_rad_s = input->p_rad_s,
        .q_rad_s = input->q_rad_s,
        .r_rad_s = input->r_rad_s,
        .speed_kt = input->speed_kt,
        // the autopilot's elevator command is limited to 0.1, less than many airframes need in level flight
        .autotrim = input->autotrim || input->autopilot,
        .frozen = is_frozen(loop, input, dt_s),
    };
    const line_law_input_t state = {
        .position = input->position,
        .state =
            {
                .altitude_ft = input->altitude_ft,
                .vvi_ft_min = input->vvi_ft_min,
                .track_deg = track_deg,
                .pitch_deg = input->pitch_deg,
                .roll_deg = input->roll_deg,
                .speed_kt = input->speed_kt,
                .frozen = rates.frozen,
            },
        .rate_per_command_rad_s = fly_by_wire_pitch_rate_rad_s(&gains->fly_by_wire, input->speed_kt),
    };
    const bool changed_hands = has_changed_hands(loop, gains, input);
    // the plan continues while the pilot flies by hand
    choose_target(loop, gains, plan, input, &state, dt_s);
    const control_command_t command = input->autopilot
                                          ? command_of_autopilot(loop, gains, input, &state, &rates, dt_s)
                                          : fly_by_wire_command_of_stick(input->stick.elevator, input->stick.aileron,
                                                                         input->stick.rudder, input->stick.throttle);
    const fly_by_wire_gains_t damping = rate_gains(gains, input->autopilot);
    const surfaces_t wanted = fly_by_wire_update(&loop->fly_by_wire, &damping, &command, &rates, dt_s);
    if (changed_hands)
    {
        transition_begin(&loop->transition, &loop->surfaces, &wanted);
    }
    loop->surfaces = transition_update(&loop->transition, &wanted, dt_s);
    loop->autopilot_was_on = input->autopilot;
    loop->law = gains->law;
    loop->autotrim_was_on = input->autotrim;
    loop->source = input->source;
    loop->has_run = true;
    return loop->surfaces;
}
