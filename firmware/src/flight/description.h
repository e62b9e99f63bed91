/// What the board says about itself: one row for each of its own gains, as a station reads it over the wire.
#ifndef FLIGHT_DESCRIPTION_H
#define FLIGHT_DESCRIPTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "comms/protocol_gen.h"

/// Rows, numbered from 0; their numbers are those of the own gains.
size_t description_count(void);

/// The payload of row `row`. False, and nothing written, if the table ends before it.
bool description_row(size_t row, uint8_t payload[MESSAGE_DESCRIPTION_ROW_SIZE]);

/// CRC-32 of the payloads of all rows in order. Takes about a millisecond on a microcontroller: ask for it once.
uint32_t description_crc32(void);

#endif
