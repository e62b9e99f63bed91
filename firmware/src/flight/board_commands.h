/// Every command that the board knows, as data.
#ifndef FLIGHT_BOARD_COMMANDS_H
#define FLIGHT_BOARD_COMMANDS_H

#include <stddef.h>

#include "comms/command.h"

/// In ascending order of type; the functions' context is a `board_command_context_t`.
extern const command_t board_commands[];
extern const size_t board_commands_count;

#endif
