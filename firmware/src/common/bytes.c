#include "common/bytes.h"

#include <string.h>

uint32_t bytes_read_u32(const uint8_t* bytes)
{
    return (uint32_t)bytes[0] | ((uint32_t)bytes[1] << 8) | ((uint32_t)bytes[2] << 16) | ((uint32_t)bytes[3] << 24);
}

void bytes_write_u32(uint8_t* bytes, uint32_t value)
{
    bytes[0] = (uint8_t)(value & 0xFFU);
    bytes[1] = (uint8_t)((value >> 8) & 0xFFU);
    bytes[2] = (uint8_t)((value >> 16) & 0xFFU);
    bytes[3] = (uint8_t)(value >> 24);
}

float bytes_read_f32(const uint8_t* bytes)
{
    const uint32_t word = bytes_read_u32(bytes);
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}

void bytes_write_f32(uint8_t* bytes, float value)
{
    uint32_t word;
    memcpy(&word, &value, sizeof word);
    bytes_write_u32(bytes, word);
}

double bytes_read_f64(const uint8_t* bytes)
{
    const uint64_t word = (uint64_t)bytes_read_u32(bytes) | ((uint64_t)bytes_read_u32(bytes + 4) << 32);
    double value;
    memcpy(&value, &word, sizeof value);
    return value;
}

void bytes_write_f64(uint8_t* bytes, double value)
{
    uint64_t word;
    memcpy(&word, &value, sizeof word);
    bytes_write_u32(bytes, (uint32_t)(word & 0xFFFFFFFFU));
    bytes_write_u32(bytes + 4, (uint32_t)(word >> 32));
}
