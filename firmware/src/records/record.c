#include "records/record.h"

#include "common/bytes.h"
#include "common/crc32.h"

enum
{
    magic_offset = 0,
    version_offset = 4,
    length_offset = 8,
    crc_bytes = 4
};

size_t record_close(uint8_t* bytes, uint32_t magic, uint32_t version, size_t payload_size)
{
    const size_t end = (size_t)record_payload_offset + payload_size;
    bytes_write_u32(bytes + magic_offset, magic);
    bytes_write_u32(bytes + version_offset, version);
    bytes_write_u32(bytes + length_offset, (uint32_t)payload_size);
    bytes_write_u32(bytes + end, crc32_of(bytes, end));
    return end + (size_t)crc_bytes;
}

record_state_t record_open(const uint8_t* bytes, size_t size, bool is_cut, uint32_t magic, uint32_t newest,
                           uint32_t* version)
{
    if (size < (size_t)record_frame_bytes || bytes_read_u32(bytes + magic_offset) != magic)
    {
        return record_damaged;
    }
    *version = bytes_read_u32(bytes + version_offset);
    const bool is_newer = *version > newest;
    if (is_cut)
    {
        // Only a newer layout can be longer than the buffer; its CRC was not read then.
        return is_newer ? record_newer : record_damaged;
    }
    const size_t crc_offset = size - (size_t)crc_bytes;
    if (bytes_read_u32(bytes + crc_offset) != crc32_of(bytes, crc_offset))
    {
        return record_damaged;
    }
    if (is_newer)
    {
        return record_newer;
    }
    const size_t payload_size = size - (size_t)record_frame_bytes;
    return bytes_read_u32(bytes + length_offset) == payload_size ? record_whole : record_damaged;
}

bool record_is_alarming(record_state_t state)
{
    return state != record_absent && state != record_whole;
}
