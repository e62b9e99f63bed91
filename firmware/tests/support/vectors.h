/// What the tables in the generated `vectors_gen.h` are made of.
#ifndef SUPPORT_VECTORS_H
#define SUPPORT_VECTORS_H

#include <stddef.h>
#include <stdint.h>

#include "comms/frame.h"

/// One frame that a board can send.
typedef struct
{
    const char* name;
    const uint8_t* bytes;
    size_t size;
    int refused; ///< the `frame_damage_t` it is refused with, -1: accepted
} telemetry_vector_t;

/// What the deployed station sent when one of its controls was used.
typedef struct
{
    const char* name;
    const uint8_t* bytes;
    size_t size;
    size_t commands;
} command_vector_t;

typedef struct
{
    uint32_t type_id;
    const uint8_t* payload;
    size_t payload_size;
} expected_frame_t;

/// A stream with noise, cuts or damage, and what has to come out of it.
typedef struct
{
    const char* name;
    const frame_dialect_t* dialect;
    const uint8_t* bytes;
    size_t size;
    const expected_frame_t* frames;
    size_t frame_count;
    uint32_t damage[frame_damage_count];
    uint32_t dropped_bytes; ///< in no frame
} stream_vector_t;

#endif
