/// Storage of small whole files (the board's memory card).
#ifndef HAL_STORAGE_H
#define HAL_STORAGE_H

#include <stddef.h>
#include <stdint.h>

typedef enum
{
    storage_ok,
    storage_missing,  ///< there is no such file
    storage_too_long, ///< the file is longer than the buffer; its beginning was read
    storage_failed    ///< card missing, full, worn, or nothing on it can be read
} storage_status_t;

typedef struct
{
    void* context;

    /// Read file `name` into `data` and set `*size` to the bytes that were read. Writes nothing to the card.
    storage_status_t (*read)(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size);

    /// Make `data` the whole content of file `name`, and return only when it is on the card. All or nothing: after
    /// a failure, and after a power cut at any moment of the call, the file holds what it held before or all of `data`.
    storage_status_t (*replace)(void* context, const char* name, const uint8_t* data, size_t size);
} storage_t;

#endif
