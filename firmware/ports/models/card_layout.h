/// How the boards divide their cards into blocks, and the names of the files where a folder stands for a card.
#ifndef CARD_LAYOUT_H
#define CARD_LAYOUT_H

enum
{
    card_layout_block_bytes = 4096,
    card_layout_blocks = 64,
    card_layout_program_bytes = 16 ///< of an image; real devices have their own
};

/// The file of the card's blocks, in their order.
#define CARD_LAYOUT_IMAGE "card.img"

/// Earlier boards wrote a record by turns to two files beside the image: its name with each of these endings.
#define CARD_LAYOUT_OLDER_ENDINGS {".a", ".b"}

#endif
