/// A memory of equal blocks: a flash chip, a memory card, a file in the place of one. Implemented by each port that has
/// one.
#ifndef HAL_BLOCK_DEVICE_H
#define HAL_BLOCK_DEVICE_H

#include <stddef.h>
#include <stdint.h>

typedef enum
{
    block_ok,
    block_worn,  ///< this block does not keep what is written; another one may
    block_failed ///< the device does not answer
} block_status_t;

/// `offset` and `size` are multiples of `program_bytes` and stay inside of one block.
typedef struct
{
    void* context;
    uint32_t block_bytes;   ///< erased at once
    uint32_t block_count;   ///< at least 8
    uint32_t program_bytes; ///< written at once; a power cut may leave any part of it written

    /// Called before the device is used again; it may have been changed for another one meanwhile, and may not be
    /// later. NULL: it cannot be changed.
    block_status_t (*begin)(void* context);

    block_status_t (*read)(void* context, uint32_t block, uint32_t offset, uint8_t* data, size_t size);

    /// Write bytes that were erased before and not written since.
    block_status_t (*program)(void* context, uint32_t block, uint32_t offset, const uint8_t* data, size_t size);

    /// A device that never held anything reads as bytes of 0xFF, or all of 0; what an erased block reads as does not
    /// matter.
    block_status_t (*erase)(void* context, uint32_t block);

    /// Return only when everything written is on the device.
    block_status_t (*sync)(void* context);
} block_device_t;

#endif
