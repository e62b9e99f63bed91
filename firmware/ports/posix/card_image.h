/// The card's blocks: the file `card.img` of a folder. Only the card's thread uses it.
#ifndef CARD_IMAGE_H
#define CARD_IMAGE_H

#include <stdbool.h>

#include "hal/block_device.h"

/// The device; it works between `card_image_open` and `card_image_close`.
const block_device_t* card_image_device(void);

/// Open the image. A missing image reads as a card that never held anything, and is made by the first write. False when
/// an existing image cannot be opened, or a missing one could not be made.
bool card_image_open(const char* folder, bool for_writing);

void card_image_close(void);

#endif
