/// Every command that the board knows, as data.
#ifndef FLIGHT_BOARD_COMMANDS_H
#define FLIGHT_BOARD_COMMANDS_H

#include "flight/board.h"

/// What the rows of the table get to work on.
typedef struct
{
    board_t* board;
    uint32_t now_ms;
} board_command_context_t;

/// Ascending in type; context is a `board_command_context_t`.
extern const command_t board_commands[];
extern const size_t board_commands_count;

#endif
