/// A record: the contents of one file of the card, in a form that tells damage, another kind and a newer layout apart.
///
/// magic (u32, the kind of record), version (u32, of the layout), length of the payload (u32), payload, CRC-32 of
/// everything before it. Little-endian. The frame around the payload is the same in every version.
#ifndef RECORDS_RECORD_H
#define RECORDS_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum
{
    record_payload_offset = 12,
    record_frame_bytes = 16 ///< magic, version, length and CRC
};

/// State of one record of the card after the last load or store.
typedef enum
{
    record_absent,     ///< nothing was stored yet
    record_whole,      ///< the card holds it, complete
    record_damaged,    ///< length, CRC or a value is wrong
    record_newer,      ///< newer firmware wrote it; it is left as it is
    record_unreadable, ///< the card itself cannot be read
    record_unwritten   ///< it could not be written
} record_state_t;

/// Write the frame around `payload_size` bytes that stand at `bytes + record_payload_offset`; returns the whole size.
size_t record_close(uint8_t* bytes, uint32_t magic, uint32_t version, size_t payload_size);

/// Check the frame around the contents of a file; `newest` is the version that this firmware writes. `record_whole`
/// with the record's own version in `*version`, `record_newer` or `record_damaged`. A record cut off at `size`
/// (`is_cut`) can only be newer or damaged.
record_state_t record_open(const uint8_t* bytes, size_t size, bool is_cut, uint32_t magic, uint32_t newest,
                           uint32_t* version);

/// True for the states that the pilot has to hear of.
bool record_is_alarming(record_state_t state);

#endif
