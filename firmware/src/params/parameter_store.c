#include "params/parameter_store.h"

#include <string.h>

#include "common/bytes.h"
#include "common/crc32.h"

enum
{
    slot_count = 2,
    magic_offset = 0,
    version_offset = 4,
    sequence_offset = 8,
    count_offset = 12,
    values_offset = 16,
    crc_offset = parameter_record_bytes - 4
};

static const uint32_t magic = 0x46504550U; ///< "PEPF"
static const uint32_t record_version = 1U; ///< of this layout and of the parameters' order
static const char* const slot_names[slot_count] = {"params.a", "params.b"};

/// What a slot holds.
typedef struct
{
    bool is_whole;
    parameters_t parameters;
    uint32_t sequence;
} slot_t;

void parameter_record_write(uint8_t* bytes, const parameters_t* parameters, uint32_t sequence)
{
    bytes_write_u32(bytes + magic_offset, magic);
    bytes_write_u32(bytes + version_offset, record_version);
    bytes_write_u32(bytes + sequence_offset, sequence);
    bytes_write_u32(bytes + count_offset, parameters_count);
    for (size_t i = 0; i < parameters_count; i++)
    {
        bytes_write_f32(bytes + values_offset + 4 * i, parameters->values[i]);
    }
    bytes_write_u32(bytes + crc_offset, crc32_of(bytes, crc_offset));
}

bool parameter_record_read(const uint8_t* bytes, size_t size, parameters_t* parameters, uint32_t* sequence)
{
    if (size != parameter_record_bytes || bytes_read_u32(bytes + magic_offset) != magic ||
        bytes_read_u32(bytes + version_offset) != record_version ||
        bytes_read_u32(bytes + count_offset) != parameters_count ||
        bytes_read_u32(bytes + crc_offset) != crc32_of(bytes, crc_offset))
    {
        return false;
    }
    parameters_t read;
    for (size_t i = 0; i < parameters_count; i++)
    {
        read.values[i] = bytes_read_f32(bytes + values_offset + 4 * i);
    }
    if (!parameters_are_valid(&read))
    {
        return false;
    }
    *parameters = read;
    *sequence = bytes_read_u32(bytes + sequence_offset);
    return true;
}

/// False only when the card itself failed; a slot that is missing or damaged is just not whole.
static bool read_slot(const storage_t* storage, size_t index, slot_t* slot)
{
    // one byte more than a record, so that a longer file is seen to be one
    uint8_t bytes[parameter_record_bytes + 1];
    size_t size = 0;
    slot->is_whole = false;
    slot->sequence = 0;
    const storage_status_t status = storage->read(storage->context, slot_names[index], bytes, sizeof bytes, &size);
    if (status == storage_ok)
    {
        slot->is_whole = parameter_record_read(bytes, size, &slot->parameters, &slot->sequence);
    }
    return status != storage_failed;
}

/// True when `a` was written after `b`, also across the counter's wrap.
static bool is_newer(uint32_t a, uint32_t b)
{
    return a != b && a - b < 0x80000000U;
}

/// Place of the newest whole slot, or -1.
static int newest_slot(const slot_t slots[slot_count])
{
    if (slots[0].is_whole && slots[1].is_whole)
    {
        return is_newer(slots[1].sequence, slots[0].sequence) ? 1 : 0;
    }
    if (slots[0].is_whole)
    {
        return 0;
    }
    return slots[1].is_whole ? 1 : -1;
}

storage_status_t parameter_store_load(const storage_t* storage, parameters_t* parameters)
{
    slot_t slots[slot_count];
    bool readable = true;
    for (size_t i = 0; i < slot_count; i++)
    {
        readable = read_slot(storage, i, &slots[i]) && readable;
    }
    const int newest = newest_slot(slots);
    if (newest < 0)
    {
        return readable ? storage_missing : storage_failed;
    }
    *parameters = slots[newest].parameters;
    return storage_ok;
}

storage_status_t parameter_store_save(const storage_t* storage, const parameters_t* parameters)
{
    slot_t slots[slot_count];
    for (size_t i = 0; i < slot_count; i++)
    {
        // a slot that cannot be read may be the one to mend by writing it
        (void)read_slot(storage, i, &slots[i]);
    }
    const int newest = newest_slot(slots);
    const size_t target = newest == 0 ? 1 : 0;
    const uint32_t sequence = newest < 0 ? 1U : slots[newest].sequence + 1U;
    uint8_t bytes[parameter_record_bytes];
    parameter_record_write(bytes, parameters, sequence);
    if (storage->replace(storage->context, slot_names[target], bytes, sizeof bytes) != storage_ok)
    {
        return storage_failed;
    }
    slot_t written;
    if (!read_slot(storage, target, &written) || !written.is_whole || written.sequence != sequence ||
        memcmp(written.parameters.values, parameters->values, sizeof parameters->values) != 0)
    {
        return storage_failed;
    }
    return storage_ok;
}
