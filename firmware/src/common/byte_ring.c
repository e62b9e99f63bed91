#include "common/byte_ring.h"

#include <string.h>

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

void byte_ring_init(byte_ring_t* ring, uint8_t* bytes, size_t capacity)
{
    ring->bytes = bytes;
    ring->capacity = capacity;
    atomic_init(&ring->written, 0U);
    atomic_init(&ring->taken, 0U);
}

size_t byte_ring_room(const byte_ring_t* ring)
{
    return ring->capacity - (atomic_load(&ring->written) - atomic_load(&ring->taken));
}

size_t byte_ring_put(byte_ring_t* ring, const uint8_t* bytes, size_t size)
{
    const size_t count = smaller(size, byte_ring_room(ring));
    if (count == 0U)
    {
        return 0U;
    }
    const size_t written = atomic_load(&ring->written);
    const size_t at = written & (ring->capacity - 1U);
    const size_t to_the_end = smaller(count, ring->capacity - at);
    memcpy(ring->bytes + at, bytes, to_the_end);
    memcpy(ring->bytes, bytes + to_the_end, count - to_the_end);
    // A release store: the reader must not see the new count before the bytes.
    atomic_store(&ring->written, written + count);
    return count;
}

size_t byte_ring_take(byte_ring_t* ring, uint8_t* bytes, size_t capacity)
{
    size_t count = 0U;
    const uint8_t* piece = NULL;
    for (size_t size = byte_ring_peek(ring, &piece); size > 0U && count < capacity; size = byte_ring_peek(ring, &piece))
    {
        const size_t part = smaller(size, capacity - count);
        memcpy(bytes + count, piece, part);
        byte_ring_skip(ring, part);
        count += part;
    }
    return count;
}

size_t byte_ring_peek(const byte_ring_t* ring, const uint8_t** bytes)
{
    const size_t taken = atomic_load(&ring->taken);
    const size_t at = taken & (ring->capacity - 1U);
    *bytes = ring->bytes + at;
    return smaller(atomic_load(&ring->written) - taken, ring->capacity - at);
}

void byte_ring_skip(byte_ring_t* ring, size_t size)
{
    atomic_store(&ring->taken, atomic_load(&ring->taken) + size);
}
