/// What the parts of the shell hand each other: what it works on, its commands, and one call of a command.
#ifndef APP_SHELL_CALL_H
#define APP_SHELL_CALL_H

#include <stddef.h>
#include <stdint.h>

#include "app/load.h"
#include "app/task_table.h"
#include "app/text.h"
#include "flight/board.h"
#include "hal/sensors.h"

/// What a line or a command asks of the application, because the card makes it wait or because all starts anew.
typedef enum
{
    shell_asks_nothing,
    shell_asks_reset,
    shell_asks_load,               ///< parameters from the card; answered in the text mode
    shell_asks_store,              ///< parameters to the card; answered in the text mode
    shell_asks_store_acknowledged, ///< the same by the station's command, acknowledged when they are there
    shell_asks_store_plans         ///< what was uploaded to the card; nobody waits for it
} shell_request_t;

/// What the shell works on; the application keeps it up to date.
typedef struct
{
    board_t* board;
    const sensors_t* sensors;
    const load_t* load;
    const task_health_t* health;    ///< of each task
    const char* restart_reason;     ///< NULL: the board did not restart itself
    const uint32_t* frames_dropped; ///< frames that the line was too slow for
    uint32_t now_ms;                ///< since the board started
    shell_request_t request;        ///< the application takes it
} shell_t;

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
    uint32_t type_id; ///< the board's command that it stands for, 0: none
    int32_t argument; ///< and its i32, where it has one; else the function's own constant
};

#endif
