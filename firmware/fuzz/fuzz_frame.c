// The frame decoder against its rule, which is written a second time here in the simplest way: over all bytes at once,
// without a buffer. Any bytes, in any pieces, with a pause of the line at any place.
#include "fuzz.h"

#include <string.h>

#include "comms/protocol_gen.h"

enum
{
    marker_bytes = 4
};

/// A stream up to a pause of the line, as the rule reads it.
typedef struct
{
    const frame_dialect_t* dialect;
    const uint8_t* bytes;
    size_t size;
    size_t at; ///< first byte that is not judged yet
    uint32_t frames;
    uint32_t refused;  ///< headers without a frame after them
    uint32_t noise;    ///< bytes outside of frames and refused headers
    size_t frame_size; ///< of the newest frame, which ends at `at`
} rule_t;

/// Length of the frame that begins here and ends before the pause; 0: no frame.
static size_t frame_here(const rule_t* rule)
{
    const uint8_t* const bytes = rule->bytes + rule->at;
    const size_t left = rule->size - rule->at;
    if (left < frame_overhead_bytes)
    {
        return 0U;
    }
    const uint32_t type = protocol_get_u32(bytes + 4);
    const int32_t payload_size = rule->dialect->payload_size(type & 0x0FFFFFFFU);
    if ((type & 0xF0000000U) != rule->dialect->type_flags || payload_size < 0)
    {
        return 0U;
    }
    const size_t size = frame_overhead_bytes + (size_t)payload_size;
    if (left < size)
    {
        return 0U;
    }
    uint32_t sum = 0U;
    for (size_t i = 4U; i < size - 4U; i += 4U)
    {
        sum += protocol_get_u32(bytes + i);
    }
    return sum == 0U && memcmp(bytes + size - 4U, "\r\n\r\n", 4U) == 0 ? size : 0U;
}

/// The next event before the pause.
static frame_event_t rule_next(rule_t* rule)
{
    uint8_t header[marker_bytes];
    protocol_put_u32(header, rule->dialect->header);
    while (rule->at < rule->size)
    {
        const uint8_t* const bytes = rule->bytes + rule->at;
        const bool is_whole = rule->size - rule->at >= marker_bytes;
        if (is_whole && rule->dialect->has_greeting && memcmp(bytes, "#QT\n", marker_bytes) == 0)
        {
            rule->at += marker_bytes;
            return frame_event_greeting;
        }
        if (!is_whole || memcmp(bytes, header, marker_bytes) != 0)
        {
            rule->at++;
            rule->noise++;
            continue;
        }
        rule->frame_size = frame_here(rule);
        if (rule->frame_size > 0U)
        {
            rule->frames++;
            rule->at += rule->frame_size;
            return frame_event_frame;
        }
        rule->at += marker_bytes;
        rule->refused++;
    }
    return frame_event_none;
}

static void compare_event(frame_event_t event, const frame_t* frame, rule_t* rule)
{
    fuzz_require(rule_next(rule) == event, "the decoder finds the same events as the rule, in the same order");
    if (event != frame_event_frame)
    {
        return;
    }
    uint8_t again[frame_max_bytes];
    const size_t size =
        frame_encode(rule->dialect, frame->type_id, frame->payload, frame->payload_size, again, sizeof again);
    fuzz_require(size == rule->frame_size, "a decoded frame, encoded again, has the same length");
    fuzz_require(memcmp(again, rule->bytes + rule->at - size, size) == 0,
                 "a decoded frame, encoded again, has the same bytes");
}

static void hear(frame_decoder_t* decoder, const uint8_t* bytes, size_t size, rule_t* rule)
{
    frame_t frame;
    while (size > 0U)
    {
        const size_t taken = frame_decoder_feed(decoder, bytes, size);
        fuzz_require(taken > 0U && taken <= size, "there is room once all events are taken");
        bytes += taken;
        size -= taken;
        for (frame_event_t event = frame_decoder_next(decoder, &frame); event != frame_event_none;
             event = frame_decoder_next(decoder, &frame))
        {
            compare_event(event, &frame, rule);
        }
    }
}

/// Give all bytes of `rule` in pieces, then let the line be silent, so that every byte is judged.
static void hear_until_pause(frame_decoder_t* decoder, rule_t* rule, fuzz_input_t* input)
{
    for (size_t at = 0U; at < rule->size;)
    {
        const size_t piece = fuzz_piece(input, rule->size - at);
        hear(decoder, rule->bytes + at, piece, rule);
        at += piece;
    }
    frame_decoder_expire(decoder);
    frame_t frame;
    for (frame_event_t event = frame_decoder_next(decoder, &frame); event != frame_event_none;
         event = frame_decoder_next(decoder, &frame))
    {
        compare_event(event, &frame, rule);
    }
    fuzz_require(rule_next(rule) == frame_event_none, "no event of the rule is missed");
    fuzz_require(!frame_decoder_is_waiting(decoder), "after silence no bytes are held");
}

static void require_counters(const frame_decoder_t* decoder, const rule_t* one, const rule_t* other)
{
    fuzz_require(decoder->received == one->frames + other->frames, "every frame is counted");
    fuzz_require(frame_decoder_rejected(decoder) == one->refused + other->refused, "every refused header is counted");
    fuzz_require(decoder->noise_bytes == one->noise + other->noise, "every byte of noise is counted");
}

/// Whatever was received before, a good frame after a pause is found, and nothing else.
static void require_next_frame(frame_decoder_t* decoder)
{
    const bool to_board = decoder->dialect->type_flags == 0U;
    const uint32_t type = to_board ? COMMAND_SERVO_OUT_ID : MESSAGE_AHRS_ID;
    const size_t payload_size = (size_t)decoder->dialect->payload_size(type);
    uint8_t payload[frame_payload_max_bytes];
    memset(payload, 0x5A, sizeof payload);
    uint8_t bytes[frame_max_bytes];
    const size_t size = frame_encode(decoder->dialect, type, payload, payload_size, bytes, sizeof bytes);
    fuzz_require(frame_decoder_feed(decoder, bytes, size) == size, "an empty decoder has room for a frame");
    frame_t frame;
    fuzz_require(frame_decoder_next(decoder, &frame) == frame_event_frame, "a good frame after garbage is found");
    fuzz_require(frame.type_id == type && frame.payload_size == payload_size &&
                     memcmp(frame.payload, payload, payload_size) == 0,
                 "and is the one that was sent");
    fuzz_require(frame_decoder_next(decoder, &frame) == frame_event_none, "nothing but the good frame is found");
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    fuzz_input_t input;
    if (!fuzz_read_input(&input, bytes, size))
    {
        return 0;
    }
    static frame_decoder_t decoder;
    const frame_dialect_t* const dialect = fuzz_dialect(input.flags);
    frame_decoder_init(&decoder, dialect);
    // half of the inputs have a pause only at the end
    const bool has_pause = (input.flags & 0x100U) != 0U && input.line_size > 0U;
    const size_t pause_at = has_pause ? (input.flags >> 16U) % input.line_size : 0U;
    rule_t before = {.dialect = dialect, .bytes = input.line, .size = pause_at};
    rule_t behind = {.dialect = dialect, .bytes = input.line + pause_at, .size = input.line_size - pause_at};
    hear_until_pause(&decoder, &before, &input);
    hear_until_pause(&decoder, &behind, &input);
    require_counters(&decoder, &before, &behind);
    require_next_frame(&decoder);
    return 0;
}
