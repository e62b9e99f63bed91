/// The servo outputs. Implemented by each port.
#ifndef HAL_SERVOS_H
#define HAL_SERVOS_H

#include <stddef.h>

typedef struct
{
    void* context;

    /// Drive outputs 0..`count`-1 to these positions, -1..+1 (throttle 0..1).
    void (*write)(void* context, const float* positions, size_t count);
} servos_t;

#endif
