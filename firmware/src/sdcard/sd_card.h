/// A memory card (SDSC, SDHC or SDXC) as a device of blocks. Knows no hardware: a port gives it the bus.
///
/// Sectors of 512 bytes are written whole, one at a time, and a write returns when the card has stored it. Nothing is
/// erased: the card does that by itself. A power cut leaves the sector that is being written old, new or
/// unreadable, which is reported as worn. What the card does to other sectors then is beyond this driver.
#ifndef SDCARD_SD_CARD_H
#define SDCARD_SD_CARD_H

#include <stdbool.h>
#include <stdint.h>

#include "hal/block_device.h"
#include "hal/spi.h"

/// Private to sd_card.c except `device`.
typedef struct
{
    const spi_t* spi;
    bool is_ready;       ///< identified, and it has answered since
    bool counts_sectors; ///< its addresses count sectors, not bytes
    block_device_t device;
} sd_card_t;

/// The first `block_count` blocks of `block_bytes` (a multiple of 512) of the card in the slot, if there is one.
/// `device.begin` identifies the card unless the one identified before still answers; until then, and after a failure
/// to answer, every other call fails at once. This call sends nothing.
void sd_card_init(sd_card_t* card, const spi_t* spi, uint32_t block_bytes, uint32_t block_count);

#endif
