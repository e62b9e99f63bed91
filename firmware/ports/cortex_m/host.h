/// What the computer that emulates the processor lends it: a folder as its memory card, and options. An image for the
/// processor itself (`host_none.c`) has neither, one for an emulator (`host_semihosting.c`) asks for them.
#ifndef HOST_H
#define HOST_H

#include <stdbool.h>

#include "hal/storage.h"

/// NULL: there is none, and nothing can be stored.
const storage_t* host_card(void);

/// Whether the board was started with this option.
bool host_has_option(const char* option);

#endif
