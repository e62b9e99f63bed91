#include "sdcard/sd_crc.h"

static const uint32_t crc7_polynomial = 0x12U; ///< 0x09, shifted by the end bit
static const uint32_t crc16_polynomial = 0x1021U;

uint8_t sd_crc7(const uint8_t* bytes, size_t size)
{
    uint32_t crc = 0U;
    for (size_t i = 0U; i < size; i++)
    {
        crc ^= bytes[i];
        for (uint32_t bit = 0U; bit < 8U; bit++)
        {
            const uint32_t shifted = crc << 1U;
            crc = (crc & 0x80U) != 0U ? shifted ^ crc7_polynomial : shifted;
        }
        crc &= 0xFFU;
    }
    return (uint8_t)(crc | 1U);
}

uint16_t sd_crc16(const uint8_t* bytes, size_t size)
{
    uint32_t crc = 0U;
    for (size_t i = 0U; i < size; i++)
    {
        crc ^= (uint32_t)bytes[i] << 8U;
        for (uint32_t bit = 0U; bit < 8U; bit++)
        {
            const uint32_t shifted = crc << 1U;
            crc = (crc & 0x8000U) != 0U ? shifted ^ crc16_polynomial : shifted;
        }
        crc &= 0xFFFFU;
    }
    return (uint16_t)crc;
}
