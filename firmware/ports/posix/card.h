/// The memory card: an image in a folder of the PC.
#ifndef CARD_H
#define CARD_H

#include <stdbool.h>
#include <stddef.h>

#include "hal/storage.h"

/// Use `folder` (made if missing) as the card, and start its thread. False, with a sentence in `error`, when that
/// fails.
bool card_start(const char* folder, char* error, size_t error_bytes);

/// The card as the application sees it. A task that uses it waits, and the other tasks run meanwhile.
/// One task at a time may use it.
const storage_t* card_storage(void);

/// Wait until nothing is being written. Called by a device thread when the board ends.
void card_settle(void);

#endif
