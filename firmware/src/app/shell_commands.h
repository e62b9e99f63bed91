/// The shell's commands as data.
#ifndef APP_SHELL_COMMANDS_H
#define APP_SHELL_COMMANDS_H

#include <stddef.h>

#include "app/shell_call.h"

/// A command stands before those whose words begin like its own; so search the table from its end.
extern const shell_command_t shell_commands[];
extern const size_t shell_commands_count;

#endif
