/// Lines and sentences of the shell's answers.
#ifndef APP_SHELL_REPLY_H
#define APP_SHELL_REPLY_H

#include <stdbool.h>

#include "app/text.h"
#include "comms/command.h"

/// Begin a line of the answer, and end it. `shell_line` does both around one text.
void shell_begin(text_t* reply);
void shell_end(text_t* reply);
void shell_line(text_t* reply, const char* words);

/// One sentence about the result of a command.
void shell_tell_result(text_t* reply, command_result_t result);

/// One sentence about a store of the parameters, and about a load.
void shell_tell_stored(text_t* reply, bool done);
void shell_tell_loaded(text_t* reply, bool done);

#endif
