/// What the computer that emulates the processor lends it: a folder as its memory card, and options. An image for the
/// processor itself (`host_none.c`) has the card in the machine's slot and no options, one for an emulator
/// (`host_semihosting.c`) asks for both.
#ifndef HOST_H
#define HOST_H

#include <stdbool.h>
#include <stdint.h>

#include "hal/storage.h"

/// NULL: there is no place for one, and nothing can be stored.
const storage_t* host_card(void);

/// Whether the board was started with this option, and the word behind it; NULL without.
bool host_has_option(const char* option);
const char* host_word_after(const char* option);

/// `patience` of the watchdog: an emulated processor shares the computer with others.
extern const uint32_t host_patience;

#endif
