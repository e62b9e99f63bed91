#include "flight/description.h"

#include <string.h>

#include "common/crc32.h"
#include "flight/own_gains.h"

/// Put `text` into `room` bytes that are zero, as far as it fits.
static void put_text(char* field, size_t room, const char* text)
{
    for (size_t i = 0U; i < room && text[i] != '\0'; i++)
    {
        field[i] = text[i];
    }
}

size_t description_count(void)
{
    return own_gains_count();
}

bool description_row(size_t row, uint8_t payload[MESSAGE_DESCRIPTION_ROW_SIZE])
{
    own_gain_t gain;
    if (!own_gains_describe(row, &gain))
    {
        return false;
    }
    const bool is_choice = gain.choices[0] != '\0';
    message_description_row_t values;
    memset(&values, 0, sizeof values);
    values.row = (int32_t)row;
    values.kind = MESSAGE_DESCRIPTION_ROW_KIND_GAIN;
    values.type = is_choice ? MESSAGE_DESCRIPTION_ROW_TYPE_ENUM : MESSAGE_DESCRIPTION_ROW_TYPE_F32;
    values.needs_restart = MESSAGE_DESCRIPTION_ROW_NEEDS_RESTART_NO;
    values.minimum = gain.minimum;
    values.maximum = gain.maximum;
    values.step = gain.step;
    values.default_value = gain.default_value;
    put_text(values.name, sizeof values.name, gain.name);
    put_text(values.unit, sizeof values.unit, gain.unit);
    put_text(values.group, sizeof values.group, gain.group);
    put_text(values.choices, sizeof values.choices, gain.choices);
    put_text(values.help, sizeof values.help, gain.help);
    message_description_row_pack(&values, payload);
    return true;
}

uint32_t description_crc32(void)
{
    uint32_t crc = 0U;
    uint8_t payload[MESSAGE_DESCRIPTION_ROW_SIZE];
    for (size_t row = 0U; description_row(row, payload); row++)
    {
        crc = crc32_with(crc, payload, sizeof payload);
    }
    return crc;
}
