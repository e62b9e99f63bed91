/// Memory card and options. An image for the processor itself (`host_none.c`) uses the card in the machine's slot and
/// has no options. One for an emulator (`host_semihosting.c`) gets options and a folder as its card from the computer.
#ifndef HOST_H
#define HOST_H

#include <stdbool.h>
#include <stdint.h>

#include "hal/storage.h"

/// The card; NULL: there is none, and nothing can be stored.
const storage_t* host_card(void);

/// Whether the board was started with this option; the word after it, NULL without the option.
bool host_has_option(const char* option);
const char* host_word_after(const char* option);

/// `patience` of the watchdog: above 1 under an emulator, which shares the computer with other programs.
extern const uint32_t host_patience;

#endif
