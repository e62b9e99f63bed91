#include "sdcard/sd_card.h"

#include <string.h>

#include "sdcard/sd_bus.h"

enum
{
    go_idle = 0,
    send_interface_condition = 8,
    send_card_data = 9,
    send_status = 13,
    set_block_length = 16,
    read_sector = 17,
    write_sector = 24,
    send_operating_condition = 41, ///< sent after `application`
    application = 55,
    read_voltages = 58,
    switch_crc = 59
};

enum
{
    idle_tries = 5,
    identify_pauses = 800, ///< together with the commands between them, more than the second that a card may need
    tries = 3,             ///< when something arrives damaged
    card_data_bytes = 16,
    word_bytes = 4
};

static const uint32_t interface_condition = 0x1AAU; ///< 2.7 to 3.6 V, and a pattern that the card sends back
static const uint32_t interface_mask = 0xFFFU;
static const uint32_t high_capacity = 0x40000000U; ///< the board supports it; in the answer: the card has it
static const uint32_t status_protected = 0x23U;    ///< locked or protected: other sectors would fail as well

static uint32_t word_of(const uint8_t* bytes)
{
    return ((uint32_t)bytes[0] << 24U) | ((uint32_t)bytes[1] << 16U) | ((uint32_t)bytes[2] << 8U) | bytes[3];
}

/// A command without data, and its answer.
static uint8_t ask(const sd_card_t* card, uint32_t index, uint32_t argument, uint8_t* more, size_t more_bytes)
{
    const uint8_t answer = sd_bus_command(card->spi, index, argument, more, more_bytes);
    sd_bus_end(card->spi);
    return answer;
}

static bool becomes_idle(const sd_card_t* card)
{
    for (uint32_t i = 0U; i < (uint32_t)idle_tries; i++)
    {
        sd_bus_wake(card->spi);
        if (ask(card, go_idle, 0U, NULL, 0U) == sd_answer_idle)
        {
            return true;
        }
        card->spi->pause(card->spi->context);
    }
    return false;
}

/// Whether the card's voltages suit, and `*is_second` whether it is of the specification's second version or later.
static bool suits(const sd_card_t* card, bool* is_second)
{
    uint8_t echo[word_bytes] = {0};
    const uint8_t answer = ask(card, send_interface_condition, interface_condition, echo, sizeof echo);
    if (answer == (sd_answer_idle | sd_answer_illegal))
    {
        *is_second = false;
        return true;
    }
    *is_second = true;
    return answer == sd_answer_idle && (word_of(echo) & interface_mask) == interface_condition;
}

static bool becomes_ready(const sd_card_t* card, bool is_second)
{
    for (uint32_t i = 0U; i < (uint32_t)identify_pauses; i++)
    {
        if (ask(card, application, 0U, NULL, 0U) > sd_answer_idle)
        {
            return false;
        }
        const uint8_t answer = ask(card, send_operating_condition, is_second ? high_capacity : 0U, NULL, 0U);
        if (answer != sd_answer_idle)
        {
            return answer == sd_answer_ready;
        }
        card->spi->pause(card->spi->context);
    }
    return false;
}

static bool finds_addresses(sd_card_t* card, bool is_second)
{
    uint8_t voltages[word_bytes] = {0};
    // Some cards report here that they are idle, although they have just reported the opposite.
    if (is_second && ask(card, read_voltages, 0U, voltages, sizeof voltages) > sd_answer_idle)
    {
        return false;
    }
    card->counts_sectors = (word_of(voltages) & high_capacity) != 0U;
    return card->counts_sectors || ask(card, set_block_length, sd_sector_bytes, NULL, 0U) == sd_answer_ready;
}

/// Number of sectors, from the card's register of 16 bytes (CSD); 0 for an unknown version of that register.
static uint32_t sectors_in(const uint8_t* data)
{
    const uint32_t version = (uint32_t)data[0] >> 6U;
    if (version == 1U)
    {
        const uint32_t size = (((uint32_t)data[7] & 0x3FU) << 16U) | ((uint32_t)data[8] << 8U) | data[9];
        return (size + 1U) << 10U;
    }
    if (version != 0U)
    {
        return 0U;
    }
    const uint32_t size = (((uint32_t)data[6] & 0x03U) << 10U) | ((uint32_t)data[7] << 2U) | ((uint32_t)data[8] >> 6U);
    const uint32_t multiplier = (((uint32_t)data[9] & 0x03U) << 1U) | ((uint32_t)data[10] >> 7U);
    const uint32_t length = (uint32_t)data[5] & 0x0FU;
    // (size + 1) blocks of 2^(multiplier+2) times 2^length bytes; a sector has 2^9
    return length < 9U || length > 11U ? 0U : (size + 1U) << (multiplier + 2U + length - 9U);
}

static bool is_large_enough(const sd_card_t* card)
{
    uint8_t data[card_data_bytes];
    const bool is_told = sd_bus_command(card->spi, send_card_data, 0U, NULL, 0U) == sd_answer_ready &&
                         sd_bus_read(card->spi, data, sizeof data) == sd_done;
    sd_bus_end(card->spi);
    return is_told && sectors_in(data) >= card->device.block_count * (card->device.block_bytes / sd_sector_bytes);
}

/// From here on the card checks checksums as well (`switch_crc`), so that it refuses a write that a restart of the
/// board interrupted.
static bool identify(sd_card_t* card)
{
    bool is_second = false;
    card->spi->set_fast(card->spi->context, false);
    if (!becomes_idle(card) || !suits(card, &is_second) || ask(card, switch_crc, 1U, NULL, 0U) != sd_answer_idle ||
        !becomes_ready(card, is_second) || !finds_addresses(card, is_second) || !is_large_enough(card))
    {
        return false;
    }
    card->spi->set_fast(card->spi->context, true);
    return true;
}

/// Ask the card how its last operation ended.
static block_status_t look_at_status(const sd_card_t* card)
{
    uint8_t status = 0xFFU;
    if (ask(card, send_status, 0U, &status, 1U) != sd_answer_ready || (status & status_protected) != 0U)
    {
        return block_failed;
    }
    return status == 0U ? block_ok : block_worn;
}

static sd_result_t try_to_read(const sd_card_t* card, uint32_t address, uint8_t* data)
{
    const uint8_t answer = sd_bus_command(card->spi, read_sector, address, NULL, 0U);
    if (answer == sd_answer_ready)
    {
        return sd_bus_read(card->spi, data, sd_sector_bytes);
    }
    return answer == sd_answer_crc ? sd_damaged : sd_silent;
}

static sd_result_t try_to_write(const sd_card_t* card, uint32_t address, const uint8_t* data)
{
    const uint8_t answer = sd_bus_command(card->spi, write_sector, address, NULL, 0U);
    if (answer == sd_answer_ready)
    {
        return sd_bus_write(card->spi, data);
    }
    return answer == sd_answer_crc ? sd_damaged : sd_silent;
}

/// Transfer one sector: read it, or write it when `to` is NULL.
static block_status_t move_sector(sd_card_t* card, uint32_t sector, uint8_t* to, const uint8_t* from)
{
    const uint32_t address = card->counts_sectors ? sector : sector * (uint32_t)sd_sector_bytes;
    sd_result_t result = sd_damaged;
    for (uint32_t i = 0U; card->is_ready && i < (uint32_t)tries && result == sd_damaged; i++)
    {
        result = to != NULL ? try_to_read(card, address, to) : try_to_write(card, address, from);
        sd_bus_end(card->spi);
    }
    block_status_t status = result == sd_done ? block_ok : block_failed;
    if (result == sd_refused || (result == sd_done && to == NULL))
    {
        status = look_at_status(card);
        status = result == sd_refused && status == block_ok ? block_worn : status;
    }
    // After a failure the card may have been exchanged, so it has to be identified again before it is used.
    card->is_ready = card->is_ready && status != block_failed;
    return status;
}

static uint32_t sector_of(const sd_card_t* card, uint32_t block, uint32_t offset)
{
    return block * (card->device.block_bytes / sd_sector_bytes) + offset / sd_sector_bytes;
}

static block_status_t begin(void* context)
{
    sd_card_t* const card = context;
    if (!card->is_ready || look_at_status(card) == block_failed)
    {
        card->is_ready = identify(card);
    }
    return card->is_ready ? block_ok : block_failed;
}

static block_status_t read_block(void* context, uint32_t block, uint32_t offset, uint8_t* data, size_t size)
{
    sd_card_t* const card = context;
    block_status_t status = block_ok;
    for (size_t at = 0U; at < size && status == block_ok; at += sd_sector_bytes)
    {
        status = move_sector(card, sector_of(card, block, offset + (uint32_t)at), data + at, NULL);
    }
    return status;
}

static block_status_t program_block(void* context, uint32_t block, uint32_t offset, const uint8_t* data, size_t size)
{
    sd_card_t* const card = context;
    block_status_t status = block_ok;
    for (size_t at = 0U; at < size && status == block_ok; at += sd_sector_bytes)
    {
        status = move_sector(card, sector_of(card, block, offset + (uint32_t)at), NULL, data + at);
    }
    return status;
}

/// Nothing to erase: sectors are overwritten as a whole.
static block_status_t erase_block(void* context, uint32_t block)
{
    const sd_card_t* const card = context;
    return card->is_ready && block < card->device.block_count ? block_ok : block_failed;
}

/// Nothing to do: each write has waited for the card.
static block_status_t sync_card(void* context)
{
    const sd_card_t* const card = context;
    return card->is_ready ? block_ok : block_failed;
}

void sd_card_init(sd_card_t* card, const spi_t* spi, uint32_t block_bytes, uint32_t block_count)
{
    memset(card, 0, sizeof *card);
    card->spi = spi;
    card->device = (block_device_t){
        .context = card,
        .block_bytes = block_bytes,
        .block_count = block_count,
        .program_bytes = sd_sector_bytes,
        .begin = begin,
        .read = read_block,
        .program = program_block,
        .erase = erase_block,
        .sync = sync_card,
    };
}
