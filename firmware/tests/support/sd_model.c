#include "support/sd_model.h"

#include <string.h>

#include "sdcard/sd_crc.h"

enum
{
    idle = 0x01,
    illegal = 0x04,
    command_crc = 0x08,
    address_error = 0x20,
    write_ms = 3
};

static bool happens(long* times)
{
    const bool does = *times > 0;
    *times -= does ? 1 : 0;
    return does;
}

static void say(sd_model_t* model, uint8_t byte)
{
    model->answer[model->answer_size] = byte;
    model->answer_size++;
}

/// A command's first answer, behind one byte of silence.
static void answer(sd_model_t* model, uint8_t bits)
{
    model->answer_at = 0;
    model->answer_size = 0;
    say(model, 0xFF);
    say(model, (uint8_t)(bits | (model->is_idle ? idle : 0)));
}

static void say_word(sd_model_t* model, uint32_t word)
{
    for (uint32_t shift = 32; shift > 0; shift -= 8)
    {
        say(model, (uint8_t)(word >> (shift - 8)));
    }
}

static void say_block(sd_model_t* model, const uint8_t* data, size_t size)
{
    if (model->has_no_token)
    {
        return;
    }
    say(model, 0xFF);
    say(model, 0xFE);
    memcpy(model->answer + model->answer_size, data, size);
    const uint16_t crc = sd_crc16(data, size);
    if (happens(&model->damaged_reads))
    {
        model->answer[model->answer_size + size / 2] ^= 0x10U;
    }
    model->answer_size += size;
    say(model, (uint8_t)(crc >> 8));
    say(model, (uint8_t)crc);
}

/// The register in which a card says how large it is.
static void say_card_data(sd_model_t* model)
{
    const uint32_t sectors = model->told_sectors != 0 ? model->told_sectors : sd_model_sectors;
    uint8_t data[16] = {0};
    if (model->is_high_capacity)
    {
        // in units of 1024 sectors, so a model of a card is told to be larger than it is
        const uint32_t size = (sectors + 1023) / 1024 - 1;
        data[0] = 0x40;
        data[7] = (uint8_t)(size >> 16);
        data[8] = (uint8_t)(size >> 8);
        data[9] = (uint8_t)size;
    }
    else
    {
        // blocks of 512 bytes, times 4
        const uint32_t size = sectors / 4 - 1;
        data[5] = 0x09;
        data[6] = (uint8_t)(size >> 10);
        data[7] = (uint8_t)(size >> 2);
        data[8] = (uint8_t)(size << 6);
    }
    if (model->csd_version != 0xFF)
    {
        data[0] = (uint8_t)(model->csd_version << 6);
    }
    say_block(model, data, sizeof data);
}

static bool sector_at(const sd_model_t* model, uint32_t address, uint32_t* sector)
{
    *sector = model->is_high_capacity ? address : address / sd_model_sector_bytes;
    return *sector < sd_model_sectors && (model->is_high_capacity || address % sd_model_sector_bytes == 0);
}

static void read_sector(sd_model_t* model, uint32_t address)
{
    uint32_t sector = 0;
    if (!sector_at(model, address, &sector))
    {
        answer(model, address_error);
        return;
    }
    answer(model, 0);
    if (model->is_unreadable[sector])
    {
        say(model, 0x04); // the token of an error that the card cannot correct
        return;
    }
    say_block(model, model->sectors[sector], sd_model_sector_bytes);
}

static void announce_write(sd_model_t* model, uint32_t address)
{
    const bool is_there = sector_at(model, address, &model->write_to);
    answer(model, is_there ? 0 : address_error);
    model->takes_block = is_there;
}

static void begin_operation(sd_model_t* model)
{
    if (!model->is_application)
    {
        answer(model, illegal);
        return;
    }
    model->is_idle = model->stays_idle || (model->is_idle && model->pauses % 4 != 0);
    answer(model, 0);
}

static void run_when_ready(sd_model_t* model, uint32_t index, uint32_t argument)
{
    switch (index)
    {
    case 9:
        answer(model, 0);
        say_card_data(model);
        break;
    case 13:
        answer(model, 0);
        say(model, model->is_locked ? 0x01 : 0x00);
        break;
    case 16:
        answer(model, argument == sd_model_sector_bytes ? 0 : address_error);
        break;
    case 17:
        read_sector(model, argument);
        break;
    case 24:
        announce_write(model, argument);
        break;
    default:
        answer(model, illegal);
        break;
    }
}

static void run(sd_model_t* model, uint32_t index, uint32_t argument)
{
    const bool was_application = model->is_application;
    model->is_application = index == 55;
    switch (index)
    {
    case 0:
        if (!happens(&model->deaf_idles))
        {
            model->is_on = true;
            model->is_idle = true;
            model->checks_crc = false;
            answer(model, 0);
        }
        break;
    case 8:
        answer(model, model->is_first_version ? illegal : 0);
        if (!model->is_first_version)
        {
            say_word(model, model->has_other_voltage ? 0x0AAU : argument);
        }
        break;
    case 41:
        model->is_application = was_application;
        begin_operation(model);
        model->is_application = false;
        break;
    case 55:
        answer(model, 0);
        break;
    case 58:
        answer(model, 0);
        say_word(model, 0x80FF8000U | (model->is_high_capacity ? 1U << 30 : 0));
        break;
    case 59:
        model->checks_crc = argument == 1;
        answer(model, model->refuses_crc ? illegal : 0);
        break;
    default:
        if (model->is_idle)
        {
            answer(model, illegal);
        }
        else
        {
            run_when_ready(model, index, argument);
        }
        break;
    }
}

static void take_command(sd_model_t* model)
{
    const uint8_t* const frame = model->received;
    const uint32_t index = frame[0] & 0x3FU;
    const bool is_damaged = happens(&model->damaged_commands);
    const uint32_t argument =
        (uint32_t)frame[1] << 24 | (uint32_t)frame[2] << 16 | (uint32_t)frame[3] << 8 | (uint32_t)frame[4];
    model->bad_crcs += sd_crc7(frame, 5) != frame[5] ? 1 : 0;
    if (!model->is_on && index != 0)
    {
        return; // not on this kind of bus yet
    }
    if (is_damaged)
    {
        answer(model, command_crc);
        return;
    }
    run(model, index, argument);
}

/// Write the block that came in, as far as the power lasts.
static void write_block(sd_model_t* model)
{
    uint8_t* const sector = model->sectors[model->write_to];
    const uint8_t* const data = model->received + 1;
    size_t reach = sd_model_sector_bytes;
    model->writes++;
    if (model->writes_until_cut == 0)
    {
        const size_t reaches[sd_cut_count] = {0, sd_model_sector_bytes / 2, sd_model_sector_bytes, 100};
        reach = reaches[model->cut];
        model->is_unreadable[model->write_to] = model->cut == sd_cut_unreadable;
        model->is_absent = true;
    }
    else
    {
        model->is_unreadable[model->write_to] = false;
    }
    model->writes_until_cut -= model->writes_until_cut > 0 ? 1 : 0;
    memcpy(sector, data, reach);
}

static void take_block(sd_model_t* model)
{
    const uint8_t* const data = model->received + 1;
    const uint32_t told = (uint32_t)data[sd_model_sector_bytes] << 8 | data[sd_model_sector_bytes + 1];
    const bool is_whole = told == sd_crc16(data, sd_model_sector_bytes);
    model->bad_crcs += is_whole ? 0 : 1;
    model->answer_at = 0;
    model->answer_size = 0;
    if (happens(&model->damaged_writes) || (model->checks_crc && !is_whole))
    {
        say(model, 0xEB);
        return;
    }
    if (model->is_worn[model->write_to])
    {
        say(model, 0xED);
        return;
    }
    say(model, 0xE5);
    model->busy_ms = write_ms;
    model->is_busy_for_ever = model->stays_busy;
    write_block(model);
}

/// One byte from the processor, where the card waits for one.
static void hear(sd_model_t* model, uint8_t byte)
{
    if (model->received_size == 0)
    {
        const bool is_command = (byte & 0xC0U) == 0x40U;
        const bool is_block = model->takes_block && byte == 0xFE;
        model->wanted_size = is_block ? sizeof model->received : 6;
        if (!is_command && !is_block)
        {
            return;
        }
    }
    model->received[model->received_size] = byte;
    model->received_size++;
    if (model->received_size == model->wanted_size)
    {
        model->received_size = 0;
        if (model->wanted_size == 6)
        {
            model->takes_block = false;
            take_command(model);
        }
        else
        {
            model->takes_block = false;
            take_block(model);
        }
    }
}

static uint8_t transfer(sd_model_t* model, uint8_t byte)
{
    if (model->is_line_low || model->is_absent || !model->is_selected)
    {
        return model->is_line_low ? 0x00 : 0xFF;
    }
    if (model->answer_at < model->answer_size)
    {
        const uint8_t said = model->answer[model->answer_at];
        model->answer_at++;
        return said;
    }
    if (model->busy_ms > 0 || model->is_busy_for_ever)
    {
        return 0x00;
    }
    hear(model, byte);
    return 0xFF;
}

static void set_fast(void* context, bool fast)
{
    sd_model_t* const model = context;
    model->is_fast = fast;
}

static void choose(void* context, bool on)
{
    sd_model_t* const model = context;
    model->is_selected = on;
    model->answer_size = on ? model->answer_size : 0;
}

static bool exchange(void* context, const uint8_t* out, uint8_t* in, size_t size)
{
    sd_model_t* const model = context;
    for (size_t i = 0; i < size; i++)
    {
        model->bytes++;
        model->too_fast += model->is_fast && (!model->is_on || model->is_idle) && !model->is_absent ? 1 : 0;
        if (model->bytes_until_pulled >= 0 && model->bytes_until_pulled-- == 0)
        {
            model->is_absent = true;
        }
        const uint8_t back = transfer(model, out != NULL ? out[i] : 0xFF);
        if (in != NULL)
        {
            in[i] = back;
        }
    }
    return model->bus_fails_from == 0 || size < model->bus_fails_from;
}

static void pause(void* context)
{
    sd_model_t* const model = context;
    model->pauses++;
    model->busy_ms -= model->busy_ms > 0 ? 1 : 0;
}

void sd_model_init(sd_model_t* model)
{
    memset(model, 0, sizeof *model);
    model->is_high_capacity = true;
    model->csd_version = 0xFF;
    sd_model_restart(model);
}

void sd_model_restart(sd_model_t* model)
{
    model->is_absent = false;
    model->bytes_until_pulled = -1;
    model->writes_until_cut = -1;
    model->is_on = false;
    model->is_idle = false;
    model->is_application = false;
    model->checks_crc = false;
    model->takes_block = false;
    model->received_size = 0;
    model->answer_size = 0;
    model->answer_at = 0;
    model->busy_ms = 0;
    model->is_busy_for_ever = false;
    model->spi =
        (spi_t){.context = model, .set_fast = set_fast, .select = choose, .exchange = exchange, .pause = pause};
}
