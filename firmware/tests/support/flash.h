/// A block device in memory: its power can be cut at any write, and its blocks can be bad.
#ifndef SUPPORT_FLASH_H
#define SUPPORT_FLASH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/block_device.h"
#include "volume/volume.h"

enum
{
    flash_block_bytes = 1024, ///< small, so that littlefs often has to move things
    flash_blocks = 32,
    flash_program_bytes = 16
};

/// What the write that the power is cut in leaves behind.
typedef enum
{
    flash_cut_before, ///< nothing of it
    flash_cut_within, ///< its first half
    flash_cut_after,  ///< all of it, and nobody heard of that
    flash_cut_count
} flash_cut_t;

typedef struct
{
    uint8_t bytes[flash_blocks][flash_block_bytes];
    long writes;           ///< erases, and programs of `flash_program_bytes`, done
    long writes_until_cut; ///< that still succeed; negative: the power stays
    flash_cut_t cut;
    bool is_off;                 ///< every call fails; set by the cut
    bool cannot_read;            ///< every read fails
    bool cannot_write;           ///< every write fails
    bool is_worn[flash_blocks];  ///< says that it does not keep what is written
    bool is_stuck[flash_blocks]; ///< keeps what it has, and says that all went well
    long written_twice;          ///< programs of bytes that were not erased; has to stay 0
    block_device_t device;
    volume_t volume;
} flash_t;

/// A device that never held anything, and a volume on it.
void flash_init(flash_t* flash);

/// The power comes back: what is on the device stays, all else begins anew.
void flash_restart(flash_t* flash);

#endif
