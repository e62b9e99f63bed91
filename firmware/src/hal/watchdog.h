/// What restarts a board that hangs. Implemented by each port.
#ifndef HAL_WATCHDOG_H
#define HAL_WATCHDOG_H

#include <stdint.h>

typedef struct
{
    void* context;
    uint32_t patience; ///< the tasks' deadlines are that many times longer: 1 on a processor of the board's own

    /// All tasks are well. Call it at least twice a second from the first call on.
    void (*feed)(void* context);

    /// Restart, because this task hangs; `task` is its name. Does not return.
    void (*give_up)(void* context, const char* task);
} watchdog_t;

#endif
