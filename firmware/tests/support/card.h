/// Files of a memory card, in memory, without a file system.
#ifndef SUPPORT_CARD_H
#define SUPPORT_CARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/storage.h"

enum
{
    card_files_max = 6,
    card_file_bytes = 3072,
    card_name_bytes = 32
};

typedef struct
{
    char name[card_name_bytes];
    uint8_t data[card_file_bytes];
    size_t size;
} card_file_t;

typedef struct
{
    card_file_t files[card_files_max];
    size_t count;
    bool has_failed;   ///< every call fails
    bool lies;         ///< a write is said to be done and nothing is written
    bool cannot_write; ///< what it holds can be read
    storage_t storage; ///< to hand to the code under test
} card_t;

void card_init(card_t* card);

/// The file, or NULL.
card_file_t* card_find(card_t* card, const char* name);

#endif
