/// The serial line to the ground station. Implemented by each port; no call ever waits.
#ifndef HAL_UART_H
#define HAL_UART_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Called in interrupt context when bytes have come in. True when a task that was waiting for them should run now.
typedef bool (*uart_interrupt_t)(void* context);

typedef struct
{
    void* context;

    /// Take up to `capacity` received bytes; 0 when there are none.
    size_t (*read)(void* context, uint8_t* bytes, size_t capacity);

    /// Hand over as many of `size` bytes as the line takes now and return how many. A line with nobody at its other end
    /// takes everything, and it is lost.
    size_t (*write)(void* context, const uint8_t* bytes, size_t size);

    /// From now on call `interrupt` with `interrupt_context` when bytes come in.
    void (*on_receive)(void* context, uart_interrupt_t interrupt, void* interrupt_context);
} uart_t;

#endif
