/// Text for people, made and read without printf and strtof: those take memory from a heap on small systems.
#ifndef APP_TEXT_H
#define APP_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// A text that grows up to its capacity; the rest is cut off.
typedef struct
{
    char* bytes;
    size_t capacity;
    size_t size;
} text_t;

void text_init(text_t* text, char* bytes, size_t capacity);
void text_add(text_t* text, const char* words);
void text_add_int(text_t* text, int32_t value);
void text_add_unsigned(text_t* text, uint32_t value);

/// With up to `decimals` (0..6) places, without trailing zeros. Not finite or beyond 1e9: "-".
void text_add_number(text_t* text, float value, unsigned int decimals);
void text_add_double(text_t* text, double value, unsigned int decimals);

/// Add spaces, at least one, up to `width` characters from `line_start` (the `size` at the start of the line).
void text_pad(text_t* text, size_t line_start, size_t width);

/// Read a whole word as a number; false when it is not one.
bool text_read_int(const char* word, int32_t* value);
bool text_read_number(const char* word, float* value);

/// True when both words are equal, ignoring the case of ASCII letters.
bool text_is(const char* a, const char* b);

#endif
