#include "support/line.h"

#include <string.h>

void line_init(line_t* line, const frame_dialect_t* dialect)
{
    memset(line, 0, sizeof *line);
    frame_decoder_init(&line->decoder, dialect);
}

static void collect(line_t* line)
{
    frame_t frame;
    frame_event_t event;
    while ((event = frame_decoder_next(&line->decoder, &frame)) != frame_event_none)
    {
        if (event == frame_event_greeting)
        {
            line->greetings++;
            continue;
        }
        if (line->count < line_frames_max)
        {
            line_frame_t* const kept = &line->frames[line->count];
            kept->type_id = frame.type_id;
            kept->payload_size = frame.payload_size;
            memcpy(kept->payload, frame.payload, frame.payload_size);
        }
        line->count++;
    }
}

void line_feed(line_t* line, const uint8_t* bytes, size_t size, size_t chunk)
{
    while (size > 0)
    {
        size_t left = chunk == 0 || chunk > size ? size : chunk;
        while (left > 0)
        {
            const size_t taken = frame_decoder_feed(&line->decoder, bytes, left);
            bytes += taken;
            left -= taken;
            size -= taken;
            collect(line);
        }
    }
}

void line_expire(line_t* line)
{
    frame_decoder_expire(&line->decoder);
    collect(line);
}

const line_frame_t* line_newest(const line_t* line, uint32_t type_id)
{
    for (size_t i = line->count < line_frames_max ? line->count : line_frames_max; i > 0; i--)
    {
        if (line->frames[i - 1].type_id == type_id)
        {
            return &line->frames[i - 1];
        }
    }
    return NULL;
}

size_t line_count_of(const line_t* line, uint32_t type_id)
{
    size_t found = 0;
    for (size_t i = 0; i < line->count && i < line_frames_max; i++)
    {
        found += line->frames[i].type_id == type_id ? 1 : 0;
    }
    return found;
}

void line_clear(line_t* line)
{
    line->count = 0;
    line->greetings = 0;
}
