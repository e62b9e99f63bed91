/// The board's two control loops: where their input comes from.
#ifndef FLIGHT_BOARD_LOOPS_H
#define FLIGHT_BOARD_LOOPS_H

#include "flight/board.h"

/// Input of the HIL loop: the newest command 50, and the stick of the control source.
control_loop_input_t board_hil_input(const board_t* board);

/// Input of the real aircraft's loop: sensors and receiver.
control_loop_input_t board_flight_input(const board_t* board);

/// With RC as control source the transmitter's switches are the HIL autopilot and autotrim.
void board_refresh_switches(board_t* board);

/// Take one command 50: step the HIL loop and answer with its surfaces. A command with a value that is not finite or
/// a position that is none is counted and steps nothing, but gets its answer: the newest surfaces.
command_result_t board_hil_step(board_t* board, const command_xplane_info_t* info, uint32_t now_ms);

#endif
