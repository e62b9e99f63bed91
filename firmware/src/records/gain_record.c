#include "records/gain_record.h"

#include <string.h>

#include "common/bytes.h"
#include "common/crc32.h"
#include "records/record_store.h"

static const record_kind_t kind = {.name = "gains", .magic = 0x46474550U, .version = 1U}; // "PEGF"

static uint32_t key_of(const char* name)
{
    return crc32_of((const uint8_t*)name, strlen(name));
}

record_state_t gain_record_load(const storage_t* storage, uint8_t* room, size_t capacity, size_t* count)
{
    size_t size = 0U;
    uint32_t version = 0U;
    const record_state_t state = record_load(storage, &kind, room, capacity, &size, &version);
    if (state != record_whole)
    {
        return state;
    }
    const size_t gains = size - (size_t)record_frame_bytes;
    if (version != kind.version || gains % (size_t)gain_record_gain_bytes != 0U)
    {
        return record_damaged;
    }
    *count = gains / (size_t)gain_record_gain_bytes;
    return record_whole;
}

bool gain_record_find(const uint8_t* room, size_t count, const char* name, float* value)
{
    const uint32_t key = key_of(name);
    for (size_t i = 0U; i < count; i++)
    {
        const uint8_t* const gain = room + record_payload_offset + (size_t)gain_record_gain_bytes * i;
        if (bytes_read_u32(gain) == key)
        {
            *value = bytes_read_f32(gain + 4);
            return true;
        }
    }
    return false;
}

size_t gain_record_put(uint8_t* room, size_t index, const char* name, float value)
{
    uint8_t* const gain = room + record_payload_offset + (size_t)gain_record_gain_bytes * index;
    bytes_write_u32(gain, key_of(name));
    bytes_write_f32(gain + 4, value);
    return (size_t)gain_record_gain_bytes * (index + 1U);
}

record_state_t gain_record_save(const storage_t* storage, uint8_t* room, size_t capacity, size_t taken)
{
    return record_save(storage, &kind, room, capacity, taken);
}
