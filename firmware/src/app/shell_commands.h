/// The shell's commands as data.
#ifndef APP_SHELL_COMMANDS_H
#define APP_SHELL_COMMANDS_H

#include <stddef.h>
#include <stdint.h>

#include "app/shell.h"

typedef struct shell_command shell_command_t;

enum
{
    shell_words_max = 4 ///< words behind a command's own
};

/// What came in, without the command's own words.
typedef struct
{
    shell_t* shell;
    const shell_command_t* command;
    text_t* reply;
    const char* words[shell_words_max];
    size_t count;
} shell_call_t;

struct shell_command
{
    const char* words;     ///< the command's own words, one space between them
    const char* arguments; ///< for the help
    const char* help;
    size_t minimum; ///< words behind it
    size_t maximum;
    void (*run)(const shell_call_t* call);
    uint32_t type_id; ///< `shell_run_board_command`: the command it stands for
    int32_t argument; ///< and its i32, where it has one
};

/// A command comes before those whose words begin like its own, so the table is searched from its end.
extern const shell_command_t shell_commands[];
extern const size_t shell_commands_count;

/// Names of the streams, in the order of `telemetry_stream_t`, and of the tasks that send them.
extern const char* const shell_stream_names[telemetry_stream_count];
extern const char* const shell_task_names[telemetry_task_count];

/// Begin a line of the answer, and end it. `shell_line` does both around one text.
void shell_begin(text_t* reply);
void shell_end(text_t* reply);
void shell_line(text_t* reply, const char* words);

/// One sentence about the result of a command.
void shell_tell_result(text_t* reply, command_result_t result);

// Reports (shell_reports.c).
void shell_show_version(const shell_call_t* call);
void shell_show_status(const shell_call_t* call);
void shell_show_tasks(const shell_call_t* call);
void shell_show_sensors(const shell_call_t* call);
void shell_show_receiver(const shell_call_t* call);
void shell_show_servos(const shell_call_t* call);
void shell_show_hil(const shell_call_t* call);
void shell_show_flight_plan(const shell_call_t* call);
void shell_show_streams(const shell_call_t* call);

#endif
