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

    /// The clock of a card that is being identified, 100 to 400 kHz, or that of one at work, at most 12 MHz.
    void (*set_fast)(void* context, bool fast);

    /// Pull the device's select line low (`on`) or let it go.
    void (*select)(void* context, bool on);

    /// Send `size` bytes (NULL: each is 0xFF) and take those that come back (NULL: they are not wanted). False when the
    /// bus itself does not work.
    bool (*exchange)(void* context, const uint8_t* out, uint8_t* in, size_t size);

    /// Let one millisecond pass at least; other tasks run meanwhile.
    void (*pause)(void* context);
} spi_t;

#endif
