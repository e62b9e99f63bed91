/// One device on a serial peripheral bus: mode 0, eight bits, the most significant one first. Implemented by each port
/// that has a memory card on one.
#ifndef HAL_SPI_H
#define HAL_SPI_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct
{
    void* context;

    /// Set the clock: 100 to 400 kHz while the card is being identified, else 12 MHz at most.
    void (*set_fast)(void* context, bool fast);

    /// Select the device (its line low) when `on`, else deselect it.
    void (*select)(void* context, bool on);

    /// Send `size` bytes (NULL: each is 0xFF) and take the bytes that come back (NULL: throw them away). False when
    /// the bus itself does not work.
    bool (*exchange)(void* context, const uint8_t* out, uint8_t* in, size_t size);

    /// Wait for at least one millisecond; other tasks run meanwhile.
    void (*pause)(void* context);
} spi_t;

#endif
