#include "app/text.h"

#include <math.h>
#include <string.h>

void text_init(text_t* text, char* bytes, size_t capacity)
{
    text->bytes = bytes;
    text->capacity = capacity;
    text->size = 0;
}

static void add_character(text_t* text, char character)
{
    if (text->size < text->capacity)
    {
        text->bytes[text->size] = character;
        text->size++;
    }
}

void text_add(text_t* text, const char* words)
{
    for (const char* at = words; *at != '\0'; at++)
    {
        add_character(text, *at);
    }
}

static void add_digits(text_t* text, uint64_t value, unsigned int at_least)
{
    static const char numerals[] = "0123456789";
    char digits[20];
    size_t count = 0;
    uint64_t left = value;
    do
    {
        digits[count] = numerals[left % 10U];
        count++;
        left /= 10U;
    } while (left > 0U || count < at_least);
    for (; count > 0U; count--)
    {
        add_character(text, digits[count - 1U]);
    }
}

void text_add_unsigned(text_t* text, uint32_t value)
{
    add_digits(text, value, 1);
}

void text_add_int(text_t* text, int32_t value)
{
    if (value < 0)
    {
        add_character(text, '-');
    }
    add_digits(text, (uint64_t)(value < 0 ? -(int64_t)value : (int64_t)value), 1);
}

void text_add_double(text_t* text, double value, unsigned int decimals)
{
    static const double largest = 1e9;
    if (!isfinite(value) || value > largest || value < -largest)
    {
        text_add(text, "-");
        return;
    }
    uint64_t scale = 1;
    for (unsigned int i = 0; i < decimals; i++)
    {
        scale *= 10U;
    }
    uint64_t scaled = (uint64_t)llround(fabs(value) * (double)scale);
    unsigned int shown = decimals;
    while (shown > 0U && scaled % 10U == 0U)
    {
        scaled /= 10U;
        scale /= 10U;
        shown--;
    }
    if (value < 0.0 && scaled != 0U)
    {
        add_character(text, '-');
    }
    add_digits(text, scaled / scale, 1);
    if (shown > 0)
    {
        add_character(text, '.');
        add_digits(text, scaled % scale, shown);
    }
}

void text_add_number(text_t* text, float value, unsigned int decimals)
{
    text_add_double(text, (double)value, decimals);
}

void text_pad(text_t* text, size_t line_start, size_t width)
{
    do
    {
        add_character(text, ' ');
    } while (text->size < text->capacity && text->size - line_start < width);
}

/// Append at most `maximum` digits at `*word` to `value`; returns how many.
static unsigned int read_digits(const char** word, uint64_t* value, unsigned int maximum)
{
    unsigned int count = 0;
    while (**word >= '0' && **word <= '9' && count < maximum)
    {
        *value = *value * 10U + (uint64_t)(**word - '0');
        (*word)++;
        count++;
    }
    return count;
}

static bool read_sign(const char** word)
{
    const bool negative = **word == '-';
    if (**word == '-' || **word == '+')
    {
        (*word)++;
    }
    return negative;
}

bool text_read_int(const char* word, int32_t* value)
{
    const char* at = word;
    const bool negative = read_sign(&at);
    uint64_t digits = 0;
    if (read_digits(&at, &digits, 10) == 0U || *at != '\0' || digits > (uint64_t)INT32_MAX)
    {
        return false;
    }
    *value = negative ? -(int32_t)digits : (int32_t)digits;
    return true;
}

bool text_read_number(const char* word, float* value)
{
    const char* at = word;
    const bool negative = read_sign(&at);
    uint64_t digits = 0;
    unsigned int count = read_digits(&at, &digits, 9);
    double scale = 1.0;
    if (*at == '.')
    {
        at++;
        const unsigned int decimals = read_digits(&at, &digits, 9);
        for (unsigned int i = 0; i < decimals; i++)
        {
            scale *= 10.0;
        }
        count += decimals;
    }
    if (count == 0U || *at != '\0')
    {
        return false;
    }
    const float magnitude = (float)((double)digits / scale);
    *value = negative ? -magnitude : magnitude;
    return true;
}

static char lower(char character)
{
    return character >= 'A' && character <= 'Z' ? (char)(character + ('a' - 'A')) : character;
}

bool text_is(const char* a, const char* b)
{
    size_t at = 0;
    while (a[at] != '\0' && lower(a[at]) == lower(b[at]))
    {
        at++;
    }
    return a[at] == b[at];
}
