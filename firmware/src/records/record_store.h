/// Records in files of the card.
#ifndef RECORDS_RECORD_STORE_H
#define RECORDS_RECORD_STORE_H

#include <stddef.h>
#include <stdint.h>

#include "hal/storage.h"
#include "records/record.h"

/// A kind of record and where it is kept.
typedef struct
{
    const char* name;
    uint32_t magic;
    uint32_t version; ///< that this firmware writes
} record_kind_t;

/// Read the record into `room` (`capacity` bytes) and check its frame. `record_whole`, with `*size` and `*version` set,
/// or the state that says what is wrong.
record_state_t record_load(const storage_t* storage, const record_kind_t* kind, uint8_t* room, size_t capacity,
                           size_t* size, uint32_t* version);

/// Put a record around the payload of `payload_size` bytes at `room + record_payload_offset`, write it and read it back
/// into `room`, which is overwritten by that. `record_whole` when the card holds it. A record of newer firmware is not
/// replaced: `record_newer`.
record_state_t record_save(const storage_t* storage, const record_kind_t* kind, uint8_t* room, size_t capacity,
                           size_t payload_size);

#endif
