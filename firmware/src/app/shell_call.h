/// The types that the files of the shell share: its state, a command, and one call of a command.
#ifndef APP_SHELL_CALL_H
#define APP_SHELL_CALL_H

#include <stddef.h>
#include <stdint.h>

#include "app/load.h"
#include "app/task_table.h"
#include "app/text.h"
#include "flight/board.h"
#include "hal/sensors.h"

/// What a line or a command asks of the application: what needs the card, which takes long, and a reset.
typedef enum
{
    shell_asks_nothing,
    shell_asks_reset,
    shell_asks_load,               ///< parameters from the card; answered in the text mode
    shell_asks_store,              ///< parameters to the card; answered in the text mode
    shell_asks_store_acknowledged, ///< the same for the station's command, which is acknowledged when they are stored
    shell_asks_store_plans         ///< uploaded plans to the card; nobody waits for an answer
} shell_request_t;

/// What the shell uses and shows; the application keeps it up to date.
typedef struct
{
    board_t* board;
    const sensors_t* sensors;
    const load_t* load;
    const task_health_t* health;    ///< of each task
    const char* restart_reason;     ///< NULL: the board did not restart itself
    const uint32_t* frames_dropped; ///< frames that the line was too slow for
    uint32_t now_ms;                ///< since the board started
    shell_request_t request;        ///< read and cleared by the application
} shell_t;

typedef struct shell_command shell_command_t;

enum
{
    shell_words_max = 4 ///< words after those of the command itself
};

/// One call: the words after those of the command itself.
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
    size_t minimum; ///< number of words after it
    size_t maximum;
    void (*run)(const shell_call_t* call);
    uint32_t type_id; ///< the board's command that it runs, 0: none
    int32_t argument; ///< the i32 of that command where it has one, else a constant for `run`
};

#endif
