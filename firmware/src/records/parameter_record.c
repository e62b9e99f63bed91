#include "records/parameter_record.h"

#include "common/bytes.h"
#include "common/crc32.h"
#include "records/record_store.h"

enum
{
    values_offset = record_payload_offset + 4,
    first_version = 1,
    first_count_offset = 12, ///< after the sequence number, which tells which of the two files was written last
    first_values_offset = 16,
    first_crc_offset = first_values_offset + 4 * parameters_count,
    first_bytes = first_crc_offset + 4,
    first_sequence_offset = 8,
    first_files = 2
};

static const record_kind_t kind = {.name = "params", .magic = 0x46504550U, .version = 2U}; // "PEPF"
static const char* const first_names[first_files] = {"params.a", "params.b"};

_Static_assert((int)parameter_record_bytes >= (int)first_bytes, "room for a record of today holds one of version 1");

/// Take all values, or none of them when one is out of its range.
static bool take_values(const uint8_t* bytes, parameters_t* parameters)
{
    parameters_t read;
    for (size_t i = 0U; i < (size_t)parameters_count; i++)
    {
        read.values[i] = bytes_read_f32(bytes + 4U * i);
    }
    const bool is_valid = parameters_are_valid(&read);
    if (is_valid)
    {
        *parameters = read;
    }
    return is_valid;
}

/// A record of version 1; false, and nothing changed, when anything in it is wrong.
static bool read_first(const uint8_t* bytes, size_t size, parameters_t* parameters, uint32_t* sequence)
{
    uint32_t version = 0U;
    if (size != (size_t)first_bytes || bytes_read_u32(bytes) != kind.magic ||
        bytes_read_u32(bytes + first_count_offset) != (uint32_t)parameters_count ||
        bytes_read_u32(bytes + first_crc_offset) != crc32_of(bytes, first_crc_offset))
    {
        return false;
    }
    version = bytes_read_u32(bytes + 4);
    *sequence = bytes_read_u32(bytes + first_sequence_offset);
    return version == (uint32_t)first_version && take_values(bytes + first_values_offset, parameters);
}

/// The newer one of the two files of version 1, of those that are complete.
static record_state_t load_first(const storage_t* storage, parameters_t* parameters, uint8_t* room, size_t capacity)
{
    record_state_t state = record_absent;
    uint32_t newest = 0U;
    for (size_t i = 0U; i < (size_t)first_files; i++)
    {
        size_t size = 0U;
        const storage_status_t status = storage->read(storage->context, first_names[i], room, capacity, &size);
        parameters_t read;
        uint32_t sequence = 0U;
        if (status == storage_ok && read_first(room, size, &read, &sequence))
        {
            // the sequence number may have wrapped
            if (state != record_whole || sequence - newest < 0x80000000U)
            {
                *parameters = read;
                newest = sequence;
            }
            state = record_whole;
        }
        else if (status != storage_missing && state == record_absent)
        {
            state = status == storage_failed ? record_unreadable : record_damaged;
        }
        else
        {
            // this file adds nothing; the other one decides
        }
    }
    return state;
}

bool parameter_record_card_answers(const storage_t* storage)
{
    uint8_t first = 0U;
    size_t size = 0U;
    return storage->read(storage->context, kind.name, &first, sizeof first, &size) != storage_failed;
}

record_state_t parameter_record_load(const storage_t* storage, parameters_t* parameters, uint8_t* room, size_t capacity)
{
    size_t size = 0U;
    uint32_t version = 0U;
    const record_state_t state = record_load(storage, &kind, room, capacity, &size, &version);
    if (state == record_absent)
    {
        return load_first(storage, parameters, room, capacity);
    }
    if (state != record_whole)
    {
        return state;
    }
    const bool is_ours = version == kind.version && size == (size_t)parameter_record_bytes &&
                         bytes_read_u32(room + record_payload_offset) == (uint32_t)parameters_count;
    return is_ours && take_values(room + values_offset, parameters) ? record_whole : record_damaged;
}

size_t parameter_record_take(const parameters_t* parameters, uint8_t* room)
{
    bytes_write_u32(room + record_payload_offset, (uint32_t)parameters_count);
    for (size_t i = 0U; i < (size_t)parameters_count; i++)
    {
        bytes_write_f32(room + values_offset + 4U * i, parameters->values[i]);
    }
    return (size_t)(parameter_record_bytes - record_frame_bytes);
}

record_state_t parameter_record_save(const storage_t* storage, uint8_t* room, size_t capacity, size_t taken)
{
    return record_save(storage, &kind, room, capacity, taken);
}
