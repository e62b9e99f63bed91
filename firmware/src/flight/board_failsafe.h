/// The failsafes of the board: where each cause shows, and how the loops fly by the table.
#ifndef FLIGHT_BOARD_FAILSAFE_H
#define FLIGHT_BOARD_FAILSAFE_H

#include "flight/board.h"

/// Note what `board->sensors` lacks; `dt_s` (> 0) after the last time.
void board_failsafe_note_sensors(board_t* board, float dt_s);

/// The receiver's channel as it was heard last.
float board_failsafe_channel(const board_t* board, size_t channel);

/// The stick of the receiver: let go once that is silent.
surfaces_t board_failsafe_rc_stick(const board_t* board);

/// One step of the real aircraft's loop with what the table says of `input`, `dt_s` (> 0).
void board_failsafe_fly(board_t* board, const control_loop_input_t* input, float dt_s);

#endif
