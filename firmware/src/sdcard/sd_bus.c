#include "sdcard/sd_bus.h"

#include "sdcard/sd_crc.h"

enum
{
    wake_bytes = 10,    ///< 80 clocks
    answer_bytes = 9,   ///< an answer comes within eight bytes, after one byte of any value
    poll_bytes = 32,    ///< read without a pause between them, because most waits are shorter
    busy_pauses = 500,  ///< of at least a millisecond each: the longest time that a card may be busy
    token_pauses = 300, ///< a card has to find a sector within 100 ms
    command_bytes = 6,
    crc_bytes = 2
};

static const uint8_t idle_line = 0xFFU;
static const uint8_t block_token = 0xFEU;
static const uint8_t response_mask = 0x1FU;
static const uint8_t response_accepted = 0x05U;
static const uint8_t response_crc = 0x0BU;
static const uint8_t response_failed = 0x0DU;
static const uint8_t error_token_mask = 0xF0U; ///< these bits are 0 in an error token
static const uint8_t error_token_worn = 0x06U; ///< card controller, or error correction

/// The next byte from the card; 0xFF, as from an idle line, when the bus does not work.
static uint8_t receive(const spi_t* spi)
{
    uint8_t byte = 0xFFU;
    return spi->exchange(spi->context, NULL, &byte, 1U) ? byte : idle_line;
}

/// Wait for the first byte that is (or is not) that of an idle line, for `pauses` at most. Returns the last byte read.
static uint8_t wait_for(const spi_t* spi, bool at_rest, uint32_t pauses)
{
    uint8_t byte = receive(spi);
    for (uint32_t polls = 0U; polls < (uint32_t)poll_bytes + pauses && (byte == idle_line) != at_rest; polls++)
    {
        if (polls >= (uint32_t)poll_bytes)
        {
            spi->pause(spi->context);
        }
        byte = receive(spi);
    }
    return byte;
}

uint8_t sd_bus_command(const spi_t* spi, uint32_t index, uint32_t argument, uint8_t* more, size_t more_bytes)
{
    uint8_t frame[command_bytes] = {(uint8_t)(0x40U | index),  (uint8_t)(argument >> 24U), (uint8_t)(argument >> 16U),
                                    (uint8_t)(argument >> 8U), (uint8_t)argument,          0U};
    frame[command_bytes - 1] = sd_crc7(frame, (size_t)command_bytes - 1U);
    spi->select(spi->context, true);
    // A busy card ignores commands; the first command ends any transfer that it is in.
    if (index != 0U && wait_for(spi, true, busy_pauses) != idle_line)
    {
        return sd_answer_none;
    }
    if (!spi->exchange(spi->context, frame, NULL, sizeof frame))
    {
        return sd_answer_none;
    }
    for (size_t i = 0U; i < (size_t)answer_bytes; i++)
    {
        const uint8_t answer = receive(spi);
        if ((answer & 0x80U) == 0U)
        {
            return more_bytes == 0U || spi->exchange(spi->context, NULL, more, more_bytes) ? answer : sd_answer_none;
        }
    }
    return sd_answer_none;
}

sd_result_t sd_bus_read(const spi_t* spi, uint8_t* data, size_t size)
{
    const uint8_t token = wait_for(spi, false, token_pauses);
    if (token != block_token)
    {
        const bool is_worn = (token & error_token_mask) == 0U && (token & error_token_worn) != 0U;
        return is_worn ? sd_refused : sd_silent;
    }
    uint8_t crc[crc_bytes];
    if (!spi->exchange(spi->context, NULL, data, size) || !spi->exchange(spi->context, NULL, crc, sizeof crc))
    {
        return sd_silent;
    }
    const uint32_t told = ((uint32_t)crc[0] << 8U) | crc[1];
    return told == sd_crc16(data, size) ? sd_done : sd_damaged;
}

sd_result_t sd_bus_write(const spi_t* spi, const uint8_t* data)
{
    const uint8_t begin[] = {idle_line, block_token};
    const uint32_t sum = sd_crc16(data, sd_sector_bytes);
    const uint8_t crc[crc_bytes] = {(uint8_t)(sum >> 8U), (uint8_t)sum};
    if (!spi->exchange(spi->context, begin, NULL, sizeof begin) ||
        !spi->exchange(spi->context, data, NULL, sd_sector_bytes) ||
        !spi->exchange(spi->context, crc, NULL, sizeof crc))
    {
        return sd_silent;
    }
    const uint8_t response = wait_for(spi, false, 0U) & response_mask;
    if (wait_for(spi, true, busy_pauses) != idle_line)
    {
        return sd_silent;
    }
    if (response == response_accepted)
    {
        return sd_done;
    }
    if (response == response_crc)
    {
        return sd_damaged;
    }
    return response == response_failed ? sd_refused : sd_silent;
}

void sd_bus_end(const spi_t* spi)
{
    spi->select(spi->context, false);
    (void)receive(spi);
}

void sd_bus_wake(const spi_t* spi)
{
    spi->select(spi->context, false);
    (void)spi->exchange(spi->context, NULL, NULL, wake_bytes);
    spi->select(spi->context, true);
    (void)spi->exchange(spi->context, NULL, NULL, (size_t)sd_sector_bytes + (size_t)crc_bytes + 2U);
    sd_bus_end(spi);
}
