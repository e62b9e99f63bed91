#include "app/shell_reports.h"

#include <stdbool.h>

#include "app/shell_reply.h"
#include "navigation/routes_gen.h"

enum
{
    name_width = 21
};

const char* const shell_stream_names[telemetry_stream_count] = {
    [telemetry_heartbeat] = "heartbeat",   [telemetry_ahrs] = "ahrs",
    [telemetry_inertial] = "inertial",     [telemetry_analog] = "analog",
    [telemetry_fms_plan] = "fms_plan",     [telemetry_fms_hil_plan] = "fms_hil_plan",
    [telemetry_statistics] = "statistics", [telemetry_gps] = "gps",
    [telemetry_servos_in] = "servos_in",   [telemetry_fly_by_wire] = "fly_by_wire",
};

const char* const shell_task_names[telemetry_task_count] = {
    [telemetry_task_param] = "param",
    [telemetry_task_fms] = "fms",
    [telemetry_task_servos] = "servos",
};

/// One line: a name, a number and its unit.
static void show_number(text_t* reply, const char* name, float value, unsigned int decimals, const char* unit)
{
    const size_t start = reply->size;
    shell_begin(reply);
    text_add(reply, name);
    text_pad(reply, start, name_width);
    text_add_number(reply, value, decimals);
    text_add(reply, unit[0] == '\0' ? "" : " ");
    text_add(reply, unit);
    shell_end(reply);
}

static void show_count(text_t* reply, const char* name, uint32_t value)
{
    const size_t start = reply->size;
    shell_begin(reply);
    text_add(reply, name);
    text_pad(reply, start, name_width);
    text_add_unsigned(reply, value);
    shell_end(reply);
}

static void show_words(text_t* reply, const char* name, const char* words)
{
    const size_t start = reply->size;
    shell_begin(reply);
    text_add(reply, name);
    text_pad(reply, start, name_width);
    text_add(reply, words);
    shell_end(reply);
}

static const char* on_off(bool on)
{
    return on ? "on" : "off";
}

void shell_show_version(const shell_call_t* call)
{
    shell_line(call->reply, BOARD_FIRMWARE_NAME " " BOARD_FIRMWARE_VERSION);
}

static const char* hil_plan_title(const board_plans_t* plans)
{
    if (plans->hil_route >= 0)
    {
        return routes[plans->hil_route].title;
    }
    return plans->plan[board_plan_hil].count > 0 ? "uploaded" : "none";
}

/// Every failsafe that is active, or a dash.
static void show_failsafes(text_t* reply, const failsafe_t* hil, const failsafe_t* flight)
{
    const size_t start = reply->size;
    shell_begin(reply);
    text_add(reply, "failsafe");
    text_pad(reply, start, name_width);
    const size_t empty = reply->size;
    for (size_t cause = 0; cause < failsafe_count; cause++)
    {
        if (failsafe_is_active(hil, (failsafe_cause_t)cause) || failsafe_is_active(flight, (failsafe_cause_t)cause))
        {
            text_add(reply, reply->size == empty ? "" : ", ");
            text_add(reply, failsafe_table[cause].name);
        }
    }
    text_add(reply, reply->size == empty ? "-" : "");
    shell_end(reply);
}

/// Everything that is wrong with the card, or a dash.
static void add_card_alarms(text_t* reply, const board_card_t* card)
{
    static const char* const names[board_keeps_count] = {
        [board_keeps_parameters] = "parameters",
        [board_keeps_own_gains] = "own gains",
        [board_keeps_flight_plan] = "flight plan",
        [board_keeps_hil_plan] = "hil plan",
    };
    static const char* const states[] = {
        [record_absent] = "not stored",       [record_whole] = "stored",          [record_damaged] = "damaged",
        [record_newer] = "of newer firmware", [record_unreadable] = "unreadable", [record_unwritten] = "not written",
    };
    const size_t empty = reply->size;
    for (size_t what = 0; what < board_keeps_count; what++)
    {
        if (record_is_alarming(card->kept[what]))
        {
            text_add(reply, reply->size == empty ? "" : ", ");
            text_add(reply, names[what]);
            text_add(reply, " ");
            text_add(reply, states[card->kept[what]]);
        }
    }
    text_add(reply, reply->size == empty ? "-" : "");
}

void shell_greet(const board_card_t* card, text_t* reply)
{
    if (board_card_alarms(card))
    {
        shell_begin(reply);
        text_add(reply, "ALARM: card: ");
        add_card_alarms(reply, card);
        text_add(reply, "; defaults are used");
        shell_end(reply);
    }
}

static void show_card(text_t* reply, const board_card_t* card)
{
    const bool is_readable = card->kept[board_keeps_parameters] != record_unreadable;
    const char* const there = is_readable ? "present" : "cannot be read";
    show_words(reply, "card", card->storage == NULL ? "none" : there);
    const size_t start = reply->size;
    shell_begin(reply);
    text_add(reply, "card alarm");
    text_pad(reply, start, name_width);
    add_card_alarms(reply, card);
    shell_end(reply);
}

void shell_show_status(const shell_call_t* call)
{
    const board_t* const board = call->shell->board;
    text_t* const reply = call->reply;
    show_number(reply, "uptime", (float)call->shell->now_ms / 1000.0F, 1, "s");
    show_words(reply, "last restart", call->shell->restart_reason == NULL ? "-" : call->shell->restart_reason);
    show_words(reply, "extensions", board->is_legacy ? "none (legacy)" : "yes");
    show_card(reply, &board->card);
    show_failsafes(reply, &board->hil.missing, &board->measured.missing);
    show_words(reply, "autopilot", on_off(measurements_autopilot(&board->measured)));
    show_words(reply, "autotrim", on_off(measurements_autotrim(&board->measured)));
    show_words(reply, "airspeed source",
               board->flight.airspeed_source == COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_GPS ? "gps" : "pitot");
    show_words(reply, "altitude source",
               board->flight.altitude_source == COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_GPS ? "gps" : "barometer");
    show_words(reply, "servos follow", board->servos.mode == board_servos_hil ? "hil" : "fly-by-wire");
    show_words(reply, "hil plan", hil_plan_title(&board->plans));
    show_count(reply, "frames received", board->station.frames_received);
    show_count(reply, "frames rejected", board->station.frames_rejected);
    show_count(reply, "frames dropped", *call->shell->frames_dropped);
    show_count(reply, "hil frames", board->hil.accepted);
    show_count(reply, "hil frames refused", board->hil.refused);
    show_count(reply, "hil frames repeated", board->hil.repeated);
    show_count(reply, "hil jumps", board->hil.jumps);
    show_number(reply, "sensor load", (float)call->shell->load->percent[load_sensor_dsc], 0, "%");
    show_number(reply, "control load", (float)call->shell->load->percent[load_control_dsc], 0, "%");
}

static void show_stack(text_t* reply, const task_row_t* row, const task_health_t* health)
{
    text_add(reply, "stack ");
    if (health->is_stack_measured)
    {
        text_add_unsigned(reply, row->stack_words - health->stack_spare_words);
    }
    else
    {
        text_add(reply, "-");
    }
    text_add(reply, " of ");
    text_add_unsigned(reply, row->stack_words);
}

static void show_lateness(text_t* reply, const task_row_t* row, const task_health_t* health)
{
    if (row->period_ms != 0U)
    {
        text_add(reply, "late ");
        text_add_unsigned(reply, health->late_periods);
    }
}

void shell_show_tasks(const shell_call_t* call)
{
    for (size_t i = 0; i < task_count; i++)
    {
        const task_row_t* const row = &task_table[i];
        const size_t start = call->reply->size;
        shell_begin(call->reply);
        text_add(call->reply, row->name);
        text_pad(call->reply, start, name_width);
        text_add(call->reply, "priority ");
        text_add_unsigned(call->reply, row->priority);
        text_pad(call->reply, start, name_width + 14);
        text_add_number(call->reply, (float)call->shell->load->tasks[i].per_mille / 10.0F, 1);
        text_add(call->reply, " %");
        text_pad(call->reply, start, name_width + 22);
        show_stack(call->reply, row, &call->shell->health[i]);
        text_pad(call->reply, start, name_width + 46);
        show_lateness(call->reply, row, &call->shell->health[i]);
        shell_end(call->reply);
    }
}

void shell_show_sensors(const shell_call_t* call)
{
    const board_sensors_t* const sensors = &call->shell->board->measured.sensors;
    text_t* const reply = call->reply;
    show_number(reply, "yaw", sensors->ahrs.yaw_deg, 1, "deg");
    show_number(reply, "pitch", sensors->ahrs.pitch_deg, 1, "deg");
    show_number(reply, "roll", sensors->ahrs.roll_deg, 1, "deg");
    show_number(reply, "altitude", sensors->analog.altitude_m, 1, "m");
    show_number(reply, "pressure", sensors->analog.baro_hpa, 1, "hPa");
    show_number(reply, "airspeed", sensors->analog.calibrated_airspeed_kt, 1, "kt");
    show_number(reply, "vertical speed", sensors->analog.vvi_ft_min, 0, "ft/min");
    show_number(reply, "temperature", sensors->analog.temperature_degc, 1, "degC");
    show_number(reply, "battery", sensors->analog.battery_v, 2, "V");
    show_number(reply, "gps latitude", sensors->gps.latitude_deg, 5, "deg");
    show_number(reply, "gps longitude", sensors->gps.longitude_deg, 5, "deg");
    show_number(reply, "gps speed", sensors->gps.speed_kt, 1, "kt");
}

/// Numbered values, four in a line.
static void show_values(text_t* reply, const float* values, size_t count)
{
    enum
    {
        per_line = 4,
        column = 14
    };
    size_t start = 0;
    for (size_t i = 0; i < count; i++)
    {
        if (i % per_line == 0)
        {
            start = reply->size;
            shell_begin(reply);
        }
        else
        {
            text_pad(reply, start, column * (i % per_line));
        }
        text_add_unsigned(reply, (uint32_t)i);
        text_add(reply, ": ");
        text_add_number(reply, values[i], 3);
        if (i % per_line == per_line - 1 || i + 1 == count)
        {
            shell_end(reply);
        }
    }
}

void shell_show_receiver(const shell_call_t* call)
{
    const message_servos_in_t* const servos_in = &call->shell->board->measured.sensors.servos_in;
    show_values(call->reply, servos_in->channel, sizeof servos_in->channel / sizeof servos_in->channel[0]);
}

void shell_show_servos(const shell_call_t* call)
{
    float positions[board_servo_count];
    board_servo_positions(call->shell->board, positions);
    show_words(call->reply, "outputs 0..3 follow",
               call->shell->board->servos.mode == board_servos_hil ? "hil" : "fly-by-wire");
    show_values(call->reply, positions, board_servo_count);
}

static void show_plan(text_t* reply, const plan_t* plan)
{
    for (size_t i = 0; i < plan->count; i++)
    {
        const waypoint_t* const waypoint = &plan->waypoints[i];
        const size_t start = reply->size;
        shell_begin(reply);
        text_add(reply, i == plan->current ? "> " : "  ");
        text_add_unsigned(reply, (uint32_t)i);
        text_pad(reply, start, 8);
        text_add_double(reply, waypoint->position.latitude_deg, 5);
        text_pad(reply, start, 18);
        text_add_double(reply, waypoint->position.longitude_deg, 5);
        text_pad(reply, start, 29);
        text_add_number(reply, waypoint->altitude_ft, 0);
        text_add(reply, " ft ");
        text_add_number(reply, waypoint->speed_kt, 0);
        text_add(reply, " kt");
        shell_end(reply);
    }
}

void shell_show_hil(const shell_call_t* call)
{
    const board_t* const board = call->shell->board;
    show_words(call->reply, "source", board->hil.source == control_source_rc ? "rc" : "joystick");
    show_words(call->reply, "autopilot", on_off(board->hil.autopilot));
    show_words(call->reply, "autotrim", on_off(board->hil.autotrim));
    show_words(call->reply, "plan", hil_plan_title(&board->plans));
    show_plan(call->reply, &board->plans.plan[board_plan_hil]);
}

void shell_show_flight_plan(const shell_call_t* call)
{
    const plan_t* const plan = &call->shell->board->plans.plan[board_plan_flight];
    show_words(call->reply, "plan", plan->count > 0 ? "uploaded" : "none");
    show_plan(call->reply, plan);
}

void shell_show_streams(const shell_call_t* call)
{
    const telemetry_schedule_t* const schedule = &call->shell->board->schedule;
    for (size_t stream = 0; stream < telemetry_stream_count; stream++)
    {
        show_words(call->reply, shell_stream_names[stream], on_off(schedule->on[stream]));
    }
    for (size_t task = 0; task < telemetry_task_count; task++)
    {
        const size_t start = call->reply->size;
        shell_begin(call->reply);
        text_add(call->reply, shell_task_names[task]);
        text_add(call->reply, " task");
        text_pad(call->reply, start, name_width);
        text_add_unsigned(call->reply, schedule->period_ms[task]);
        text_add(call->reply, " ms");
        shell_end(call->reply);
    }
}
