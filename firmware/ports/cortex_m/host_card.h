/// The memory card under an emulator: the file `card.img` in a folder of the computer.
#ifndef HOST_CARD_H
#define HOST_CARD_H

#include "hal/storage.h"

/// The card in `folder`; the string must stay valid.
const storage_t* host_card_in(const char* folder);

#endif
