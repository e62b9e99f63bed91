#include "app/shell_commands.h"

#include <string.h>

#include "app/shell_reply.h"
#include "app/shell_reports.h"
#include "navigation/routes_gen.h"
#include "params/parameters_gen.h"

static const uint32_t period_commands[telemetry_task_count] = {
    [telemetry_task_param] = COMMAND_SET_PARAMETER_TASK_RATE_ID,
    [telemetry_task_fms] = COMMAND_SET_FMS_TASK_RATE_ID,
    [telemetry_task_servos] = COMMAND_SET_SERVOS_TASK_RATE_ID,
};

static const char not_a_number[] = "refused: not a number";

/// Index of `word` among `count` names, or `count`.
static size_t find(const char* word, const char* const names[], size_t count)
{
    size_t index = 0;
    while (index < count && !text_is(word, names[index]))
    {
        index++;
    }
    return index;
}

/// 1 for `on`, 0 for `off`; anything else is refused, and -1.
static int on_or_off(const shell_call_t* call, const char* word)
{
    if (text_is(word, "on") || text_is(word, "off"))
    {
        return text_is(word, "on") ? 1 : 0;
    }
    shell_line(call->reply, "refused: `on` or `off` is needed");
    return -1;
}

static void run_board_command(const shell_call_t* call)
{
    uint8_t payload[4];
    protocol_put_i32(payload, call->command->argument);
    const uint32_t type_id = call->command->type_id;
    const size_t size = protocol_command_size(type_id) > 0 ? sizeof payload : 0;
    shell_tell_result(call->reply, board_run_command(call->shell->board, type_id, payload, size, call->shell->now_ms));
}

static void show_help(const shell_call_t* call)
{
    for (size_t i = 0; i < shell_commands_count; i++)
    {
        const size_t start = call->reply->size;
        shell_begin(call->reply);
        text_add(call->reply, shell_commands[i].words);
        text_add(call->reply, " ");
        text_add(call->reply, shell_commands[i].arguments);
        text_pad(call->reply, start, 34);
        text_add(call->reply, shell_commands[i].help);
        shell_end(call->reply);
    }
}

static void show_parameter(const shell_call_t* call, size_t index)
{
    const parameter_definition_t* const definition = &parameter_definitions[index];
    const size_t start = call->reply->size;
    shell_begin(call->reply);
    text_add(call->reply, definition->name);
    text_pad(call->reply, start, 18);
    text_add_number(call->reply, call->shell->board->tuning.parameters.values[index], 5);
    text_pad(call->reply, start, 28);
    text_add(call->reply, "(");
    text_add_number(call->reply, definition->minimum, 3);
    text_add(call->reply, " to ");
    text_add_number(call->reply, definition->maximum, 3);
    text_add(call->reply, ", default ");
    text_add_number(call->reply, definition->default_value, 5);
    text_add(call->reply, ")");
    shell_end(call->reply);
}

static void run_parameter(const shell_call_t* call)
{
    for (size_t i = 0; call->count == 0 && i < parameters_count; i++)
    {
        show_parameter(call, i);
    }
    if (call->count == 0)
    {
        return;
    }
    size_t index = 0;
    while (index < parameters_count && !text_is(call->words[0], parameter_definitions[index].name))
    {
        index++;
    }
    float value = 0.0F;
    if (index == parameters_count)
    {
        shell_line(call->reply, "refused: no parameter has that name (`param` lists them)");
    }
    else if (call->count == 2 && !text_read_number(call->words[1], &value))
    {
        shell_line(call->reply, not_a_number);
    }
    else if (call->count == 2 && !tuning_set(&call->shell->board->tuning, index, value))
    {
        shell_tell_result(call->reply, command_bad_value);
    }
    else
    {
        show_parameter(call, index);
    }
}

static void load_parameters(const shell_call_t* call)
{
    call->shell->request = shell_asks_load;
}

static void store_parameters(const shell_call_t* call)
{
    call->shell->request = shell_asks_store;
}

static void load_route(const shell_call_t* call)
{
    for (size_t i = 0; i < ROUTE_COUNT; i++)
    {
        // `ruta_isla` is called `isla` for short.
        const char* const short_name = strrchr(routes[i].name, '_');
        if (text_is(call->words[0], routes[i].name) || (short_name != NULL && text_is(call->words[0], short_name + 1)))
        {
            shell_tell_result(call->reply, board_run_command(call->shell->board, routes[i].load_command, NULL, 0,
                                                             call->shell->now_ms));
            return;
        }
    }
    shell_begin(call->reply);
    text_add(call->reply, "refused: no route has that name; there are");
    for (size_t i = 0; i < ROUTE_COUNT; i++)
    {
        text_add(call->reply, " ");
        text_add(call->reply, routes[i].name);
    }
    shell_end(call->reply);
}

static void switch_stream(const shell_call_t* call)
{
    telemetry_schedule_t* const schedule = &call->shell->board->schedule;
    const int on = on_or_off(call, call->words[1]);
    const size_t stream = find(call->words[0], shell_stream_names, telemetry_stream_count);
    if (on < 0)
    {
        return;
    }
    if (text_is(call->words[0], "all"))
    {
        telemetry_switch_all(schedule, on == 1);
        shell_tell_result(call->reply, command_done);
    }
    else if (stream == telemetry_stream_count)
    {
        shell_line(call->reply, "refused: no stream has that name (`stream list` lists them)");
    }
    else if (stream == telemetry_heartbeat && on == 0)
    {
        shell_line(call->reply, "refused: the heartbeat is always on");
    }
    else
    {
        telemetry_switch(schedule, (telemetry_stream_t)stream, on == 1);
        shell_tell_result(call->reply, command_done);
    }
}

static void set_period(const shell_call_t* call)
{
    const size_t task = find(call->words[0], shell_task_names, telemetry_task_count);
    int32_t period_ms = 0;
    if (task == telemetry_task_count)
    {
        shell_line(call->reply, "refused: the tasks with a period are param, fms and servos");
    }
    else if (!text_read_int(call->words[1], &period_ms))
    {
        shell_line(call->reply, not_a_number);
    }
    else
    {
        uint8_t payload[4];
        protocol_put_i32(payload, period_ms);
        shell_tell_result(call->reply, board_run_command(call->shell->board, period_commands[task], payload,
                                                         sizeof payload, call->shell->now_ms));
    }
}

static void set_receiver_switch(const shell_call_t* call)
{
    const int on = on_or_off(call, call->words[0]);
    if (on < 0)
    {
        return;
    }
    if (call->shell->sensors->set_switch == NULL)
    {
        shell_line(call->reply, "refused: this board has a real receiver; use the transmitter");
        return;
    }
    call->shell->sensors->set_switch(call->shell->sensors->context, call->command->argument, on == 1 ? 1.0F : -1.0F);
    shell_tell_result(call->reply, command_done);
}

static void move_servo(const shell_call_t* call)
{
    int32_t servo = 0;
    float position = 0.0F;
    if (!text_read_int(call->words[0], &servo) || !text_read_number(call->words[1], &position))
    {
        shell_line(call->reply, not_a_number);
        return;
    }
    uint8_t payload[COMMAND_SERVO_OUT_SIZE];
    protocol_put_i32(payload, servo);
    protocol_put_f32(payload + 4, position);
    shell_tell_result(call->reply, board_run_command(call->shell->board, COMMAND_SERVO_OUT_ID, payload, sizeof payload,
                                                     call->shell->now_ms));
}

static void reset_board(const shell_call_t* call)
{
    call->shell->request = shell_asks_reset;
    shell_tell_result(call->reply, command_done);
}

#define BOARD_COMMAND(words, help, type_id, argument) {words, "", help, 0, 0, run_board_command, type_id, argument}

const shell_command_t shell_commands[] = {
    {"help", "", "this list", 0, 0, show_help, 0, 0},
    {"version", "", "name and version of the firmware", 0, 0, shell_show_version, 0, 0},
    {"status", "", "modes, plans and counters", 0, 0, shell_show_status, 0, 0},
    {"tasks", "", "the tasks and their load", 0, 0, shell_show_tasks, 0, 0},
    {"sensors", "", "the newest readings", 0, 0, shell_show_sensors, 0, 0},
    {"param", "[name [value]]", "show or set parameters", 0, 2, run_parameter, 0, 0},
    {"param load", "", "load the parameters from the card", 0, 0, load_parameters, 0, 0},
    {"param store", "", "store the parameters on the card", 0, 0, store_parameters, 0, 0},
    {"hil", "", "the simulated aircraft's plan and modes", 0, 0, shell_show_hil, 0, 0},
    {"hil load", "<route>", "gando, isla, alternativa or vuelo", 1, 1, load_route, 0, 0},
    BOARD_COMMAND("hil next", "next waypoint", COMMAND_HIL_FMS_NEXT_WAYPOINT_ID, 0),
    BOARD_COMMAND("hil prev", "previous waypoint", COMMAND_HIL_FMS_PREVIOUS_WAYPOINT_ID, 0),
    BOARD_COMMAND("hil source joystick", "fly by the station's stick", COMMAND_CONTROL_SOURCE_ID, 1),
    BOARD_COMMAND("hil source rc", "fly by the RC transmitter", COMMAND_CONTROL_SOURCE_ID, 0),
    BOARD_COMMAND("hil autopilot on", "autopilot of the simulated aircraft", COMMAND_AUTOPILOT_ON_ID, 0),
    BOARD_COMMAND("hil autopilot off", "manual flight of the simulated aircraft", COMMAND_AUTOPILOT_OFF_ID, 0),
    BOARD_COMMAND("hil autotrim on", "automatic elevator trim of the simulated aircraft", COMMAND_AUTOTRIM_ON_ID, 0),
    BOARD_COMMAND("hil autotrim off", "no elevator trim of the simulated aircraft", COMMAND_AUTOTRIM_OFF_ID, 0),
    {"fms", "", "the real aircraft's plan", 0, 0, shell_show_flight_plan, 0, 0},
    BOARD_COMMAND("fms next", "next waypoint", COMMAND_FMS_NEXT_WAYPOINT_ID, 0),
    BOARD_COMMAND("fms prev", "previous waypoint", COMMAND_FMS_PREVIOUS_WAYPOINT_ID, 0),
    {"stream", "<name>|all on|off", "switch a stream of binary mode", 2, 2, switch_stream, 0, 0},
    {"stream list", "", "the streams and their periods", 0, 0, shell_show_streams, 0, 0},
    {"rate", "param|fms|servos <ms>", "period of a task", 2, 2, set_period, 0, 0},
    {"rc", "", "channels of the receiver", 0, 0, shell_show_receiver, 0, 0},
    {"rc power", "on|off", "the transmitter itself", 1, 1, set_receiver_switch, 0, sensors_transmitter},
    {"rc auto", "on|off", "the transmitter's autopilot switch", 1, 1, set_receiver_switch, 0, rc_channel_autopilot},
    {"rc trim", "on|off", "the transmitter's autotrim switch", 1, 1, set_receiver_switch, 0, rc_channel_autotrim},
    {"servos", "", "positions of the outputs", 0, 0, shell_show_servos, 0, 0},
    BOARD_COMMAND("servos mode fbw", "outputs follow the fly-by-wire", COMMAND_SERVOS_CONTROL_MODE_FLY_BY_WIRE_ID, 0),
    BOARD_COMMAND("servos mode hil", "outputs follow the HIL laws", COMMAND_SERVOS_CONTROL_MODE_HIL_ID, 0),
    {"servo", "<0..19> <-1..1>", "move one output", 2, 2, move_servo, 0, 0},
    {"reset", "", "restart the board", 0, 0, reset_board, 0, 0},
};

const size_t shell_commands_count = sizeof shell_commands / sizeof shell_commands[0];
