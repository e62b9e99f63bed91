/// What each row of the command table works on.
#ifndef FLIGHT_BOARD_COMMAND_CONTEXT_H
#define FLIGHT_BOARD_COMMAND_CONTEXT_H

#include "comms/command.h"
#include "flight/board_state.h"

typedef struct
{
    board_t* board;
    uint32_t now_ms;
} board_command_context_t;

/// The board of a row's context.
static inline board_t* board_of(void* context)
{
    return ((board_command_context_t*)context)->board;
}

#endif
