/// The memory card: an image in a folder of the PC.
#ifndef CARD_H
#define CARD_H

#include <stdbool.h>
#include <stddef.h>

#include "hal/storage.h"

/// Use `folder` (made when missing) as the card and start the thread that works on it. False with a sentence in
/// `error` when that fails.
bool card_start(const char* folder, char* error, size_t error_bytes);

/// The card as the application sees it. A task that uses it waits as for any device, and the other tasks run meanwhile.
/// One task at a time may use it.
const storage_t* card_storage(void);

/// Wait until nothing is being written; for a device thread, when the board goes down.
void card_settle(void);

#endif
