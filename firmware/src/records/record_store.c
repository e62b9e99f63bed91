#include "records/record_store.h"

#include <stdbool.h>

#include "common/bytes.h"

record_state_t record_load(const storage_t* storage, const record_kind_t* kind, uint8_t* room, size_t capacity,
                           size_t* size, uint32_t* version)
{
    *size = 0U;
    switch (storage->read(storage->context, kind->name, room, capacity, size))
    {
    case storage_ok:
        return record_open(room, *size, false, kind->magic, kind->version, version);
    case storage_too_long:
        return record_open(room, *size, true, kind->magic, kind->version, version);
    case storage_missing:
        return record_absent;
    case storage_failed:
        break;
    }
    return record_unreadable;
}

/// Read the frame of the record on the card. `room` is left alone, because it holds the record that is to be written.
static bool holds_newer(const storage_t* storage, const record_kind_t* kind)
{
    uint8_t frame[record_frame_bytes] = {0};
    size_t size = 0U;
    uint32_t version = 0U;
    const storage_status_t status = storage->read(storage->context, kind->name, frame, sizeof frame, &size);
    return status == storage_too_long &&
           record_open(frame, size, true, kind->magic, kind->version, &version) == record_newer;
}

record_state_t record_save(const storage_t* storage, const record_kind_t* kind, uint8_t* room, size_t capacity,
                           size_t payload_size)
{
    if (holds_newer(storage, kind))
    {
        return record_newer;
    }
    const size_t size = record_close(room, kind->magic, kind->version, payload_size);
    const uint32_t crc = bytes_read_u32(room + size - sizeof(uint32_t));
    if (storage->replace(storage->context, kind->name, room, size) != storage_ok)
    {
        return record_unwritten;
    }
    size_t found_size = 0U;
    uint32_t version = 0U;
    const record_state_t found = record_load(storage, kind, room, capacity, &found_size, &version);
    const bool is_same = found == record_whole && version == kind->version && found_size == size &&
                         bytes_read_u32(room + size - sizeof(uint32_t)) == crc;
    return is_same ? record_whole : record_unwritten;
}
