/// Storage of small whole files (the board's memory card). Implemented by each port.
#ifndef HAL_STORAGE_H
#define HAL_STORAGE_H

#include <stddef.h>
#include <stdint.h>

typedef enum
{
    storage_ok,
    storage_missing, ///< there is no such file
    storage_failed   ///< card missing, full, worn or the file longer than the buffer
} storage_status_t;

typedef struct
{
    void* context;

    /// Read the whole file `name` into `data` and set `*size`.
    storage_status_t (*read)(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size);

    /// Make `data` the whole content of file `name`, and return only when it is on the card. A power cut during the
    /// call may leave any content in this file, but must not touch other files.
    storage_status_t (*replace)(void* context, const char* name, const uint8_t* data, size_t size);
} storage_t;

#endif
