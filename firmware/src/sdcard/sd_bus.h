/// Commands to an SD card on a serial peripheral bus, and its blocks of data (Physical Layer Simplified Specification,
/// chapter 7). Every wait has an end, and other tasks run while it lasts.
#ifndef SDCARD_SD_BUS_H
#define SDCARD_SD_BUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/spi.h"

enum
{
    sd_sector_bytes = 512
};

/// Bits of a command's first answer.
enum
{
    sd_answer_ready = 0x00,
    sd_answer_idle = 0x01, ///< not identified yet
    sd_answer_illegal = 0x04,
    sd_answer_crc = 0x08, ///< the command was damaged on its way
    sd_answer_none = 0xFF
};

typedef enum
{
    sd_done,
    sd_damaged, ///< on its way; it may be tried again
    sd_refused, ///< the card cannot do it here: this sector is worn
    sd_silent   ///< the card does not answer, or not by the rules
} sd_result_t;

/// Send command `index` and take its first answer, and the `more_bytes` that follow it. `sd_answer_none` when there is
/// no answer. The card is selected until `sd_bus_end`.
uint8_t sd_bus_command(const spi_t* spi, uint32_t index, uint32_t argument, uint8_t* more, size_t more_bytes);

/// The block of `size` bytes that follows a command's answer.
sd_result_t sd_bus_read(const spi_t* spi, uint8_t* data, size_t size);

/// The sector that a command announced; returns when the card has written it.
sd_result_t sd_bus_write(const spi_t* spi, const uint8_t* data);

/// Let the card go, with the clocks that it needs to let go of the line.
void sd_bus_end(const spi_t* spi);

/// Clocks without the card, of which it needs 74 before the first command, then some with it that end a block which a
/// restart of the board has cut in two.
void sd_bus_wake(const spi_t* spi);

#endif
