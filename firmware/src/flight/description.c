#include "flight/description.h"

#include <string.h>

#include "common/bytes.h"
#include "common/crc32.h"
#include "comms/protocol_gen.h"
#include "flight/own_gains.h"
#include "flight/own_topics.h"

/// Numbers on the wire.
enum
{
    row_is_gain = 1,
    row_is_topic = 2,
    row_is_field = 3,
    gain_is_f32 = 1,
    gain_is_enum = 5
};

static const uint32_t patience_ticks = 50; ///< a line that is never idle gets a block each half second

_Static_assert(MESSAGE_DESCRIPTION_BLOCK_SIZE == 4 + description_block_bytes, "a frame carries one block");

/// A row in the making. Room is left for the zero that ends a text: a text that is too long is cut.
typedef struct
{
    uint8_t* bytes;
    size_t size;
} row_t;

static void put_u8(row_t* row, uint8_t value)
{
    if (row->size < (size_t)description_row_max_bytes)
    {
        row->bytes[row->size] = value;
        row->size++;
    }
}

static void put_u16(row_t* row, uint16_t value)
{
    put_u8(row, (uint8_t)(value & 0xFFU));
    put_u8(row, (uint8_t)(value >> 8U));
}

static void put_f32(row_t* row, float value)
{
    uint8_t bytes[4];
    bytes_write_f32(bytes, value);
    for (size_t i = 0U; i < sizeof bytes; i++)
    {
        put_u8(row, bytes[i]);
    }
}

static void put_text(row_t* row, const char* text)
{
    for (size_t i = 0U; text[i] != '\0' && row->size + 1U < (size_t)description_row_max_bytes; i++)
    {
        put_u8(row, (uint8_t)text[i]);
    }
    put_u8(row, 0U);
}

static row_t begin_row(uint8_t* bytes, uint8_t kind)
{
    row_t row = {.bytes = bytes, .size = 0U};
    put_u8(&row, 0U); // the length, once it is known
    put_u8(&row, kind);
    return row;
}

static size_t end_row(const row_t* row)
{
    row->bytes[0] = (uint8_t)row->size;
    return row->size;
}

static size_t make_gain(const own_gain_t* gain, uint8_t* bytes)
{
    const bool is_choice = gain->choices[0] != '\0';
    row_t row = begin_row(bytes, (uint8_t)row_is_gain);
    put_u8(&row, is_choice ? (uint8_t)gain_is_enum : (uint8_t)gain_is_f32);
    put_u8(&row, 0U); // every change takes effect at once
    put_f32(&row, gain->minimum);
    put_f32(&row, gain->maximum);
    put_f32(&row, gain->step);
    put_f32(&row, gain->default_value);
    put_text(&row, gain->name);
    put_text(&row, gain->unit);
    put_text(&row, gain->group);
    put_text(&row, gain->choices);
    put_text(&row, gain->help);
    return end_row(&row);
}

static size_t make_topic(const own_topic_t* topic, uint8_t* bytes)
{
    row_t row = begin_row(bytes, (uint8_t)row_is_topic);
    put_u16(&row, topic->type_word);
    put_u16(&row, topic->period_ms);
    put_text(&row, topic->name);
    put_text(&row, topic->help);
    return end_row(&row);
}

static size_t make_field(const own_topic_field_t* field, uint8_t* bytes)
{
    row_t row = begin_row(bytes, (uint8_t)row_is_field);
    put_u8(&row, (uint8_t)field->type);
    put_f32(&row, 1.0F); // every value is sent in its unit
    put_f32(&row, field->minimum);
    put_f32(&row, field->maximum);
    put_text(&row, field->name);
    put_text(&row, field->unit);
    put_text(&row, "");
    put_text(&row, field->sign);
    return end_row(&row);
}

/// Row `row` of those of the topics.
static size_t make_topic_row(size_t row, uint8_t* bytes)
{
    size_t first = 0U;
    for (size_t i = 0U; i < (size_t)own_topic_count; i++)
    {
        const own_topic_t* const topic = own_topics_definition((own_topic_id_t)i);
        if (row == first)
        {
            return make_topic(topic, bytes);
        }
        if (row - first <= topic->field_count)
        {
            return make_field(&topic->fields[row - first - 1U], bytes);
        }
        first += 1U + topic->field_count;
    }
    return 0U;
}

size_t description_row(size_t row, uint8_t bytes[description_row_max_bytes])
{
    own_gain_t gain;
    if (own_gains_describe(row, &gain))
    {
        return make_gain(&gain, bytes);
    }
    return make_topic_row(row - own_gains_count(), bytes);
}

description_summary_t description_summary(void)
{
    description_summary_t summary = {0U, 0U};
    uint8_t row[description_row_max_bytes];
    size_t number = 0U;
    for (size_t size = description_row(number, row); size > 0U; size = description_row(number, row))
    {
        summary.size += size;
        summary.crc32 = crc32_with(summary.crc32, row, size);
        number++;
    }
    return summary;
}

bool description_block(size_t block, uint8_t bytes[description_block_bytes])
{
    const size_t begin = block * (size_t)description_block_bytes;
    const size_t end = begin + (size_t)description_block_bytes;
    uint8_t row[description_row_max_bytes];
    size_t number = 0U;
    size_t at = 0U; // where the row begins in the table
    for (size_t size = description_row(number, row); size > 0U && at < end; size = description_row(number, row))
    {
        if (at + size > begin)
        {
            const size_t skipped = at < begin ? begin - at : 0U;
            const size_t place = at + skipped - begin;
            const size_t room = (size_t)description_block_bytes - place;
            const size_t rest = size - skipped;
            memcpy(bytes + place, row + skipped, rest < room ? rest : room);
        }
        at += size;
        number++;
    }
    if (at <= begin)
    {
        return false;
    }
    if (at < end)
    {
        memset(bytes + (at - begin), 0, end - at);
    }
    return true;
}

bool description_begin_reading(description_reading_t* reading, size_t size, size_t first, size_t count)
{
    const size_t blocks = (size + (size_t)description_block_bytes - 1U) / (size_t)description_block_bytes;
    if (first >= blocks || count > blocks - first)
    {
        return false;
    }
    *reading = (description_reading_t){.next = first, .end = first + count, .waited = 0U};
    return true;
}

void description_stop_reading(description_reading_t* reading)
{
    reading->end = reading->next;
}

bool description_is_reading(const description_reading_t* reading)
{
    return reading->next < reading->end;
}

bool description_read_next(description_reading_t* reading, bool line_is_idle, size_t* block)
{
    if (!description_is_reading(reading))
    {
        return false;
    }
    reading->waited++;
    if (!line_is_idle && reading->waited < patience_ticks)
    {
        return false;
    }
    *block = reading->next;
    reading->next++;
    reading->waited = 0U;
    return true;
}
