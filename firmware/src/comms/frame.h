/// Frames on the serial line: header, type, payload, checksum, end marker. Bytes in, frames out; no input or output.
///
///     header 4 | type i32 | payload 0..n, multiple of 4, length fixed by the type | checksum i32 | 0D 0A 0D 0A
///
/// The words of type, payload and checksum add up to 0. Bits 28-31 of the type are 8 from the board and 0 to the board.
#ifndef COMMS_FRAME_H
#define COMMS_FRAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum
{
    frame_overhead_bytes = 16,     ///< everything but the payload
    frame_payload_max_bytes = 132, ///< of description_block, the longest payload of the definition
    frame_max_bytes = frame_overhead_bytes + frame_payload_max_bytes,
    frame_buffer_bytes = 2 * frame_max_bytes ///< one candidate and the bytes received after it
};

/// Everything that differs between the two directions.
typedef struct
{
    uint32_t header;     ///< as a little-endian word
    uint32_t type_flags; ///< bits 28-31 of the type on the wire: 0x80000000 from the board, 0 to the board
    int32_t (*payload_size)(uint32_t type_id); ///< bytes, or negative when the type is unknown
    bool has_greeting;                         ///< `#QT\n` between frames is a greeting, otherwise noise
} frame_dialect_t;

/// `\rQT,`: what the board sends.
extern const frame_dialect_t frame_from_board;

/// `#QT,`: what the board receives. Unknown types are refused as damage; the station's decoder does the same.
extern const frame_dialect_t frame_to_board;

/// A frame that passed every check. `payload` stays valid until the decoder is used again.
typedef struct
{
    uint32_t type_id; ///< without the flags
    const uint8_t* payload;
    size_t payload_size;
} frame_t;

typedef enum
{
    frame_event_none,    ///< more bytes are needed
    frame_event_frame,   ///< `frame` is filled in
    frame_event_greeting ///< a station opened the line, for the first time or again
} frame_event_t;

/// Why a candidate (four bytes that look like a header) was refused.
typedef enum
{
    frame_damage_type_bits,
    frame_damage_unknown_type,
    frame_damage_checksum,
    frame_damage_end,
    frame_damage_time_out,
    frame_damage_count
} frame_damage_t;

/// State of one stream; owned by the caller.
typedef struct
{
    const frame_dialect_t* dialect;
    uint8_t header[4]; ///< the dialect's, as bytes
    uint8_t buffer[frame_buffer_bytes];
    size_t start; ///< first byte that is not yet judged
    size_t end;   ///< one past the newest byte
    bool expired; ///< the held bytes will not be completed any more
    uint32_t received;
    uint32_t noise_bytes; ///< bytes outside of frames and of refused candidates' headers
    uint32_t damage[frame_damage_count];
} frame_decoder_t;

void frame_decoder_init(frame_decoder_t* decoder, const frame_dialect_t* dialect);

/// Take as many of `size` bytes as there is room for and return how many. Call `frame_decoder_next` until it returns
/// `frame_event_none`; then there is room again:
///
///     while (size > 0)
///     {
///         const size_t taken = frame_decoder_feed(&decoder, bytes, size);
///         bytes += taken;
///         size -= taken;
///         while ((event = frame_decoder_next(&decoder, &frame)) != frame_event_none) { ... }
///     }
size_t frame_decoder_feed(frame_decoder_t* decoder, const uint8_t* bytes, size_t size);

/// Return the next event. After a refused candidate the search continues at the byte after its header, so that a
/// damaged frame never hides the good one after it.
frame_event_t frame_decoder_next(frame_decoder_t* decoder, frame_t* frame);

/// The line has been silent for longer than a frame may pause: refuse the candidate that is held. Call
/// `frame_decoder_next` until it returns `frame_event_none` afterwards; complete frames inside of the refused candidate
/// come out there.
void frame_decoder_expire(frame_decoder_t* decoder);

/// True while part of a candidate is held, so that a time-out between two bytes has to be watched.
bool frame_decoder_is_waiting(const frame_decoder_t* decoder);

/// Candidates refused, of all kinds.
uint32_t frame_decoder_rejected(const frame_decoder_t* decoder);

/// Write one frame to `out` and return its length, or 0 (and nothing written) when `capacity` is too small or the
/// payload is too long or no multiple of 4 bytes.
size_t frame_encode(const frame_dialect_t* dialect, uint32_t type_id, const uint8_t* payload, size_t payload_size,
                    uint8_t* out, size_t capacity);

#endif
