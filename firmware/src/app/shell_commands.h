/// The shell's commands as data.
#ifndef APP_SHELL_COMMANDS_H
#define APP_SHELL_COMMANDS_H

#include <stddef.h>

#include "app/shell_call.h"

/// Search it from its end: a command stands before the longer ones that begin with its words.
extern const shell_command_t shell_commands[];
extern const size_t shell_commands_count;

#endif
