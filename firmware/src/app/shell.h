/// The text mode's shell: one line in, one answer out. Every line of an answer begins with `\r` and ends with `\n`.
#ifndef APP_SHELL_H
#define APP_SHELL_H

#include "app/shell_call.h"
#include "app/text.h"

enum
{
    shell_reply_bytes = 6144 ///< the longest answer: a plan of 100 waypoints
};

/// Run one line, which is changed by that, and add the answer to `reply`. A request that only the application can
/// fulfil is left in `shell->request`; the application answers it by `shell_tell_stored` or `shell_tell_loaded`.
void shell_run(shell_t* shell, char* line, text_t* reply);

#endif
