/// A mailbox of bytes from many tasks to one. A mutex guards it, and a message goes in completely or not at all, so
/// that the frames of different tasks never mix.
#ifndef APP_MAILBOX_H
#define APP_MAILBOX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "FreeRTOS.h"
#include "semphr.h"
#include "task.h"

#include "common/byte_ring.h"

enum
{
    mailbox_bytes = 4096,   ///< the longest answer of the shell, or 350 ms of a 115200 line
    mailbox_rest_bytes = 64 ///< 6 ms of it
};

typedef struct
{
    byte_ring_t ring;
    uint8_t bytes[mailbox_bytes];
    SemaphoreHandle_t mutex;
    StaticSemaphore_t mutex_memory;
    TaskHandle_t reader;
    uint32_t refused; ///< how often there was no room
} mailbox_t;

/// An empty mailbox. Set `reader` before anything is put in.
void mailbox_init(mailbox_t* mailbox);

/// Put `size` bytes in and wake the reader. False, and counted, when there is no room for all of them: on a
/// line that is too slow, frames are lost, but no task waits.
bool mailbox_put(mailbox_t* mailbox, const uint8_t* bytes, size_t size);

/// Whether the reader has taken all but `mailbox_rest_bytes`.
bool mailbox_is_all_but_empty(const mailbox_t* mailbox);

#endif
