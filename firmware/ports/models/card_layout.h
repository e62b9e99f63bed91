/// What the boards' cards have in common: how they are divided, and what a card is called where a folder stands for
/// one.
#ifndef CARD_LAYOUT_H
#define CARD_LAYOUT_H

enum
{
    card_layout_block_bytes = 4096,
    card_layout_blocks = 64,
    card_layout_program_bytes = 16 ///< of an image; what is soldered in or plugged in has its own
};

/// The card's blocks, one behind the other.
#define CARD_LAYOUT_IMAGE "card.img"

/// A record of boards before is in two files beside the image, in turn: its name with each of these.
#define CARD_LAYOUT_OLDER_ENDINGS {".a", ".b"}

#endif
