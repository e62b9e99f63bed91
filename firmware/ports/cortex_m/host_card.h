/// The memory card that an emulator lends: the file `card.img` of a folder of the computer.
#ifndef HOST_CARD_H
#define HOST_CARD_H

#include "hal/storage.h"

/// The card in `folder`, which has to stay where it is.
const storage_t* host_card_in(const char* folder);

#endif
