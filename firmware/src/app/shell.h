/// The text mode's shell: one line in, one answer out. Every line of an answer begins with `\r` and ends with `\n`.
#ifndef APP_SHELL_H
#define APP_SHELL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "app/load.h"
#include "app/task_table.h"
#include "app/text.h"
#include "flight/board.h"
#include "hal/sensors.h"

enum
{
    shell_reply_bytes = 6144 ///< the longest answer: a plan of 100 waypoints
};

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

/// Do one line (which is taken apart) and add the answer to `reply`; what is asked of the application is answered by
/// `shell_tell_stored` and `shell_tell_loaded`.
void shell_run(shell_t* shell, char* line, text_t* reply);

/// What a person has to know at the start: nothing, but what is wrong with the card.
void shell_greet(const board_t* board, text_t* reply);

void shell_tell_stored(text_t* reply, bool done);
void shell_tell_loaded(text_t* reply, bool done);

#endif
