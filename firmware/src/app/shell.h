/// The text mode's shell: one line in, one answer out. Every line of an answer begins with `\r` and ends with `\n`.
#ifndef APP_SHELL_H
#define APP_SHELL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "app/load.h"
#include "app/text.h"
#include "flight/board.h"
#include "hal/sensors.h"

enum
{
    shell_reply_bytes = 6144 ///< the longest answer: a plan of 100 waypoints
};

/// What the shell works on; the application keeps it up to date.
typedef struct
{
    board_t* board;
    const sensors_t* sensors;
    const load_t* load;
    const uint32_t* frames_dropped; ///< frames that the line was too slow for
    uint32_t now_ms;                ///< since the board started
    bool resets;                    ///< `reset` was asked for
} shell_t;

/// Do one line (which is taken apart) and add the answer to `reply`.
void shell_run(shell_t* shell, char* line, text_t* reply);

#endif
