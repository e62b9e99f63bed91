/// Ring of bytes between one writer and one reader, which may be an interrupt and a task: no lock is needed.
#ifndef COMMON_BYTE_RING_H
#define COMMON_BYTE_RING_H

#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>

typedef struct
{
    uint8_t* bytes;
    size_t capacity;       ///< a power of two
    atomic_size_t written; ///< in all, by the writer; wraps
    atomic_size_t taken;   ///< in all, by the reader; wraps
} byte_ring_t;

/// Make the ring empty. Its `capacity` bytes (a power of two) must exist as long as the ring.
void byte_ring_init(byte_ring_t* ring, uint8_t* bytes, size_t capacity);

/// Bytes that can be put now; for the writer.
size_t byte_ring_room(const byte_ring_t* ring);

/// Put as many of `size` bytes as there is room for and return how many.
size_t byte_ring_put(byte_ring_t* ring, const uint8_t* bytes, size_t size);

/// Take up to `capacity` bytes and return how many.
size_t byte_ring_take(byte_ring_t* ring, uint8_t* bytes, size_t capacity);

/// The oldest bytes in one piece, without taking them; returns how many, 0 when the ring is empty.
size_t byte_ring_peek(const byte_ring_t* ring, const uint8_t** bytes);

/// Remove `size` bytes that `byte_ring_peek` returned.
void byte_ring_skip(byte_ring_t* ring, size_t size);

#endif
