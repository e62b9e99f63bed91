#include "common/crc32.h"

uint32_t crc32_of(const uint8_t* bytes, size_t size)
{
    return crc32_with(0U, bytes, size);
}

uint32_t crc32_with(uint32_t before, const uint8_t* bytes, size_t size)
{
    uint32_t crc = ~before;
    for (size_t i = 0; i < size; i++)
    {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
        {
            crc = (crc & 1U) != 0U ? (crc >> 1) ^ 0xEDB88320U : crc >> 1;
        }
    }
    return ~crc;
}
