/// A memory card (SDSC, SDHC or SDXC) as a device of blocks. Knows no hardware: a port gives it the bus.
///
/// Sectors of 512 bytes are written whole, one at a time, and a write returns when the card has it. Nothing is erased:
/// the card does that itself before it writes. A power cut leaves the sector that is being written old, new or
/// unreadable, which is told as worn; what a card does to other sectors then is its own affair.
#ifndef SDCARD_SD_CARD_H
#define SDCARD_SD_CARD_H

#include <stdbool.h>
#include <stdint.h>

#include "hal/block_device.h"
#include "hal/spi.h"

/// Private to sd_card.c but for `device`.
typedef struct
{
    const spi_t* spi;
    bool is_ready;       ///< identified, and it has answered since
    bool counts_sectors; ///< addresses are sectors, not bytes
    block_device_t device;
} sd_card_t;

/// The first `block_count` blocks of `block_bytes` (a multiple of 512) of whatever card is plugged in, which may be
/// none. The card is identified by `device.begin` where it is not yet, or does not answer as the one that was; until
/// then, and after it failed to answer, everything else fails at once. Nothing is sent by this call.
void sd_card_init(sd_card_t* card, const spi_t* spi, uint32_t block_bytes, uint32_t block_count);

#endif
