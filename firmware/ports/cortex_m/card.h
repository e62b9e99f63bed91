/// The board's memory card, as far as the machine has one: `card_semihosting.c` where an emulator runs the image,
/// `card_none.c` on the processor itself.
#ifndef CARD_H
#define CARD_H

#include "hal/storage.h"

/// NULL: there is none, and nothing can be stored.
const storage_t* card_storage(void);

#endif
