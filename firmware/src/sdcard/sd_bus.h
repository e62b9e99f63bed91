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
    sd_answer_crc = 0x08, ///< the command arrived damaged
    sd_answer_none = 0xFF
};

typedef enum
{
    sd_done,
    sd_damaged, ///< in transit; try again
    sd_refused, ///< the card cannot do it for this sector, which is worn
    sd_silent   ///< the card does not answer, or answers against the specification
} sd_result_t;

/// Send command `index` and take its first answer, and the `more_bytes` that follow it. `sd_answer_none` when there is
/// no answer. The card is selected until `sd_bus_end`.
uint8_t sd_bus_command(const spi_t* spi, uint32_t index, uint32_t argument, uint8_t* more, size_t more_bytes);

/// Receive the block of `size` bytes that follows a command's answer.
sd_result_t sd_bus_read(const spi_t* spi, uint8_t* data, size_t size);

/// Send the sector that a command announced; returns when the card has written it.
sd_result_t sd_bus_write(const spi_t* spi, const uint8_t* data);

/// Deselect the card, with the clocks after which it releases the line.
void sd_bus_end(const spi_t* spi);

/// Send the 74 clocks that a card needs, deselected, before its first command; then some more, selected, which end a
/// block that a restart of the board interrupted.
void sd_bus_wake(const spi_t* spi);

#endif
