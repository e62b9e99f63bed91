/// The text mode's shell: one line in, one answer out. Every line of an answer begins with `\r` and ends with `\n`.
#ifndef APP_SHELL_H
#define APP_SHELL_H

#include "app/shell_call.h"
#include "app/text.h"

enum
{
    shell_reply_bytes = 6144 ///< the longest answer: a plan of 100 waypoints
};

/// Do one line (its blanks become ends of words) and add the answer to `reply`. What only the application can do is
/// left in `shell->request`; the application answers it by `shell_tell_stored` or `shell_tell_loaded`.
void shell_run(shell_t* shell, char* line, text_t* reply);

#endif
