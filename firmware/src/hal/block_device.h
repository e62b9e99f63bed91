/// A memory of equal blocks: a flash chip, a memory card, or a file that stands for one. Implemented by each port that
/// has one.
#ifndef HAL_BLOCK_DEVICE_H
#define HAL_BLOCK_DEVICE_H

#include <stddef.h>
#include <stdint.h>

typedef enum
{
    block_ok,
    block_worn,  ///< this block does not keep what is written; another block may
    block_failed ///< the device does not answer
} block_status_t;

/// `offset` and `size` are multiples of `program_bytes` and stay inside of one block.
typedef struct
{
    void* context;
    uint32_t block_bytes;   ///< erased at once
    uint32_t block_count;   ///< at least 8
    uint32_t program_bytes; ///< written at once; a power cut may leave any part of it written

    /// Called before the device is used after a pause, in which it may have been exchanged; it is not exchanged until
    /// the next call. NULL: it cannot be exchanged.
    block_status_t (*begin)(void* context);

    block_status_t (*read)(void* context, uint32_t block, uint32_t offset, uint8_t* data, size_t size);

    /// Write bytes that were erased and have not been written since.
    block_status_t (*program)(void* context, uint32_t block, uint32_t offset, const uint8_t* data, size_t size);

    /// A device that never held anything reads as all 0xFF or all 0; an erased block may read as anything.
    block_status_t (*erase)(void* context, uint32_t block);

    /// Return only when everything written is on the device.
    block_status_t (*sync)(void* context);
} block_device_t;

#endif
