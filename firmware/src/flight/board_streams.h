/// The frames whose values come from several parts of the board: telemetry streams, capabilities and status.
#ifndef FLIGHT_BOARD_STREAMS_H
#define FLIGHT_BOARD_STREAMS_H

#include "flight/board_state.h"

/// Send one stream now, whether it is on or not.
void board_send_stream(board_t* board, telemetry_stream_t stream);

/// Send the own topics that are due.
void board_send_own_topics(board_t* board, uint32_t now_ms);

void board_send_capabilities(const board_t* board, uint32_t now_ms);
void board_send_status(const board_t* board);

#endif
