/// A line for tests: bytes through the decoder in chunks of a size, and what came out of it.
#ifndef SUPPORT_LINE_H
#define SUPPORT_LINE_H

#include <stddef.h>
#include <stdint.h>

#include "comms/frame.h"

enum
{
    line_frames_max = 512
};

typedef struct
{
    uint32_t type_id;
    size_t payload_size;
    uint8_t payload[frame_payload_max_bytes];
} line_frame_t;

/// Everything that came out, in order; frames beyond `line_frames_max` are only counted.
typedef struct
{
    frame_decoder_t decoder;
    line_frame_t frames[line_frames_max];
    size_t count;
    size_t greetings;
} line_t;

void line_init(line_t* line, const frame_dialect_t* dialect);

/// Feed `bytes` in chunks of `chunk` (0: all at once) and collect.
void line_feed(line_t* line, const uint8_t* bytes, size_t size, size_t chunk);

/// The line fell silent.
void line_expire(line_t* line);

/// The newest frame of a type, or NULL.
const line_frame_t* line_newest(const line_t* line, uint32_t type_id);

/// Frames of a type.
size_t line_count_of(const line_t* line, uint32_t type_id);

/// Forget what was collected.
void line_clear(line_t* line);

#endif
