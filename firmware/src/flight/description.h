/// What the board says about itself: a table of rows, first one for each of its own gains, then each own topic and its
/// fields. A station reads the table in blocks. The table is made anew for each question and stands nowhere as a whole.
#ifndef FLIGHT_DESCRIPTION_H
#define FLIGHT_DESCRIPTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum
{
    description_block_bytes = 128,
    description_row_max_bytes = 255
};

typedef struct
{
    size_t size; ///< bytes
    uint32_t crc32;
} description_summary_t;

/// Blocks that a station asked for and has not got yet.
typedef struct
{
    size_t next;
    size_t end;      ///< one past the last; not above `next`: none
    uint32_t waited; ///< ticks that the next one has waited for the line
} description_reading_t;

/// Make row `row` and return its length. 0, and nothing written, if the table ends before it. Rows are numbered from 0;
/// the numbers of the first ones are those of the own gains.
size_t description_row(size_t row, uint8_t bytes[description_row_max_bytes]);

/// Size and checksum of the table. Takes about a millisecond on a microcontroller: ask for it once.
description_summary_t description_summary(void);

/// Make block `block`, with zeros behind the table's end. False, and nothing written, if the table ends before it.
bool description_block(size_t block, uint8_t bytes[description_block_bytes]);

/// Begin to send `count` blocks from `first` on, in place of others that are not sent yet. False, and nothing changed,
/// if one of them is behind the end of a table of `size` bytes.
bool description_begin_reading(description_reading_t* reading, size_t size, size_t first, size_t count);

void description_stop_reading(description_reading_t* reading);

bool description_is_reading(const description_reading_t* reading);

/// One tick: true when block `*block` is to be sent now. A line that is busy is given time for other frames, such as
/// the answers to command 50, but not for ever.
bool description_read_next(description_reading_t* reading, bool line_is_idle, size_t* block);

#endif
