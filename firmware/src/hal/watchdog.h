/// What restarts a board that hangs. Implemented by each port.
#ifndef HAL_WATCHDOG_H
#define HAL_WATCHDOG_H

#include <stdint.h>

typedef struct
{
    void* context;
    uint32_t patience; ///< factor of the tasks' deadlines: 1 on a processor that runs nothing else

    /// Say that all tasks run. After the first call, call it at least twice a second.
    void (*feed)(void* context);

    /// Restart, because this task hangs; `task` is its name. Does not return.
    void (*give_up)(void* context, const char* task);
} watchdog_t;

#endif
