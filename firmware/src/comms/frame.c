#include "comms/frame.h"

#include <string.h>

#include "comms/protocol_gen.h"

enum
{
    header_bytes = 4,
    type_offset = 4,
    payload_offset = 8
};

// as long as a header and equal to it except for the last byte
static const char greeting[] = PROTOCOL_OPEN_BINARY_MODE;
static const uint32_t type_flags_mask = PROTOCOL_TO_PC_TYPE_BIT | PROTOCOL_FORBIDDEN_TYPE_BITS;

_Static_assert(sizeof greeting == header_bytes + 1, "a greeting is found like a header");
_Static_assert(PROTOCOL_OVERHEAD == frame_overhead_bytes, "the frame is the one of the definition");
_Static_assert(PROTOCOL_TELEMETRY_SIZE_MAX <= frame_payload_max_bytes, "the longest telemetry fits the decoder");
_Static_assert(PROTOCOL_COMMAND_SIZE_MAX <= frame_payload_max_bytes, "the longest command fits the decoder");

const frame_dialect_t frame_from_board = {
    .header = PROTOCOL_TO_PC_HEADER,
    .type_flags = PROTOCOL_TO_PC_TYPE_BIT,
    .payload_size = protocol_telemetry_size,
    .has_greeting = false,
};

const frame_dialect_t frame_to_board = {
    .header = PROTOCOL_TO_BOARD_HEADER,
    .type_flags = 0U,
    .payload_size = protocol_command_size,
    .has_greeting = true,
};

/// Verdict on the candidate at the start of the buffer.
typedef enum
{
    verdict_incomplete,
    verdict_frame,
    verdict_refused
} verdict_t;

void frame_decoder_init(frame_decoder_t* decoder, const frame_dialect_t* dialect)
{
    memset(decoder, 0, sizeof *decoder);
    decoder->dialect = dialect;
    protocol_put_u32(decoder->header, dialect->header);
}

size_t frame_decoder_feed(frame_decoder_t* decoder, const uint8_t* bytes, size_t size)
{
    const size_t held = decoder->end - decoder->start;
    if (decoder->start > 0)
    {
        memmove(decoder->buffer, decoder->buffer + decoder->start, held);
        decoder->start = 0;
        decoder->end = held;
    }
    const size_t room = sizeof decoder->buffer - held;
    const size_t taken = size < room ? size : room;
    if (taken > 0)
    {
        memcpy(decoder->buffer + held, bytes, taken);
        decoder->end += taken;
    }
    return taken;
}

/// Skip to the next header, greeting or beginning of one at the buffer's end; true when all four bytes are there.
static bool find_marker(frame_decoder_t* decoder)
{
    while (decoder->start < decoder->end)
    {
        const uint8_t* const at = decoder->buffer + decoder->start;
        const size_t held = decoder->end - decoder->start;
        const size_t compared = held < header_bytes ? held : header_bytes;
        if (memcmp(at, decoder->header, compared) == 0 ||
            (decoder->dialect->has_greeting && memcmp(at, greeting, compared) == 0))
        {
            if (compared == header_bytes)
            {
                return true;
            }
            if (!decoder->expired)
            {
                return false;
            }
        }
        decoder->start++;
        decoder->noise_bytes++;
    }
    return false;
}

/// Add up the words from the type to the checksum; they cancel out in a good frame.
static uint32_t sum_words(const uint8_t* bytes, size_t size)
{
    uint32_t sum = 0;
    for (size_t i = 0; i < size; i += 4)
    {
        sum += protocol_get_u32(bytes + i);
    }
    return sum;
}

/// Judge the candidate: refuse it as soon as its type is known to be wrong, else when all its bytes are there.
static verdict_t judge(const frame_decoder_t* decoder, frame_t* frame, frame_damage_t* damage)
{
    const uint8_t* const at = decoder->buffer + decoder->start;
    const size_t held = decoder->end - decoder->start;
    if (held < payload_offset)
    {
        return verdict_incomplete;
    }
    const uint32_t type = protocol_get_u32(at + type_offset);
    if ((type & type_flags_mask) != decoder->dialect->type_flags)
    {
        *damage = frame_damage_type_bits;
        return verdict_refused;
    }
    const uint32_t type_id = type & ~type_flags_mask;
    const int32_t payload_size = decoder->dialect->payload_size(type_id);
    if (payload_size < 0 || payload_size > frame_payload_max_bytes)
    {
        *damage = frame_damage_unknown_type;
        return verdict_refused;
    }
    const size_t size = (size_t)payload_size;
    if (held < frame_overhead_bytes + size)
    {
        return verdict_incomplete;
    }
    if (protocol_get_u32(at + payload_offset + size + 4) != PROTOCOL_END)
    {
        *damage = frame_damage_end;
        return verdict_refused;
    }
    if (sum_words(at + type_offset, 4 + size + 4) != 0)
    {
        *damage = frame_damage_checksum;
        return verdict_refused;
    }
    *frame = (frame_t){.type_id = type_id, .payload = at + payload_offset, .payload_size = size};
    return verdict_frame;
}

static void refuse(frame_decoder_t* decoder, frame_damage_t damage)
{
    decoder->damage[damage]++;
    decoder->start += header_bytes;
}

frame_event_t frame_decoder_next(frame_decoder_t* decoder, frame_t* frame)
{
    while (find_marker(decoder))
    {
        const uint8_t* const at = decoder->buffer + decoder->start;
        if (decoder->dialect->has_greeting && memcmp(at, greeting, header_bytes) == 0)
        {
            decoder->start += header_bytes;
            return frame_event_greeting;
        }
        frame_damage_t damage = frame_damage_time_out;
        const verdict_t verdict = judge(decoder, frame, &damage);
        if (verdict == verdict_frame)
        {
            decoder->start += frame_overhead_bytes + frame->payload_size;
            decoder->received++;
            return frame_event_frame;
        }
        if (verdict == verdict_incomplete && !decoder->expired)
        {
            return frame_event_none;
        }
        refuse(decoder, damage);
    }
    decoder->expired = false;
    return frame_event_none;
}

void frame_decoder_expire(frame_decoder_t* decoder)
{
    decoder->expired = true;
}

bool frame_decoder_is_waiting(const frame_decoder_t* decoder)
{
    return decoder->start < decoder->end;
}

uint32_t frame_decoder_rejected(const frame_decoder_t* decoder)
{
    uint32_t sum = 0;
    for (size_t i = 0; i < frame_damage_count; i++)
    {
        sum += decoder->damage[i];
    }
    return sum;
}

size_t frame_encode(const frame_dialect_t* dialect, uint32_t type_id, const uint8_t* payload, size_t payload_size,
                    uint8_t* out, size_t capacity)
{
    if (payload_size > frame_payload_max_bytes || payload_size % 4 != 0 ||
        capacity < frame_overhead_bytes + payload_size)
    {
        return 0;
    }
    protocol_put_u32(out, dialect->header);
    protocol_put_u32(out + type_offset, type_id | dialect->type_flags);
    if (payload_size > 0)
    {
        memcpy(out + payload_offset, payload, payload_size);
    }
    const uint32_t checksum = 0U - sum_words(out + type_offset, 4 + payload_size);
    protocol_put_u32(out + payload_offset + payload_size, checksum);
    protocol_put_u32(out + payload_offset + payload_size + 4, PROTOCOL_END);
    return frame_overhead_bytes + payload_size;
}
