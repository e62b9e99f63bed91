/// What the board keeps on its card: parameters and uploaded plans, each whole or not at all.
///
/// A store has three steps, so that nobody waits for the card who only needs the board: take, write, note. Between them
/// the card and `card_room` belong to the caller; only `board_card_write` needs time.
#ifndef FLIGHT_BOARD_CARD_H
#define FLIGHT_BOARD_CARD_H

#include <stdbool.h>
#include <stddef.h>

#include "flight/board.h"

/// Parameters and plans from the card. What it does not hold whole stays as it is: defaults, no plan.
void board_card_load(board_t* board);

/// Only read the parameters; the board does not fly by them yet. Needs the card, not the board.
record_state_t board_card_read_parameters(board_t* board, parameters_t* parameters);

/// Copy what is to be kept; returns how many bytes that is. A plan that was uploaded counts as stored from here on.
size_t board_card_take(board_t* board, board_keeps_t what);

/// Put what was taken on the card. Needs the card, not the board. `record_whole` when it is there.
record_state_t board_card_write(board_t* board, board_keeps_t what, size_t taken);

/// Remember what became of it; true when the card's alarm came or went by that.
bool board_card_note(board_t* board, board_keeps_t what, record_state_t state);

/// The next uploaded plan that is not taken yet, or `board_keeps_count`.
board_keeps_t board_card_next(const board_t* board);

/// True while something that the card should hold is damaged, newer than this firmware, unreadable or not written.
bool board_card_alarms(const board_t* board);

#endif
