/// Frames that the board sends: one function for each that is not a stream of its own accord.
#ifndef FLIGHT_BOARD_REPORTS_H
#define FLIGHT_BOARD_REPORTS_H

#include "flight/board.h"

/// Send one stream now, whether it is on or not.
void board_report_stream(board_t* board, telemetry_stream_t stream);

void board_report_surfaces(board_t* board, const surfaces_t* surfaces);
void board_report_parameters(board_t* board);
void board_report_capabilities(board_t* board, uint32_t now_ms);
void board_report_acknowledgement(board_t* board, uint32_t type_id, command_result_t result);
void board_report_status(board_t* board);
void board_report_mission_count(board_t* board, int32_t plan);
void board_report_mission_item(board_t* board, int32_t plan, size_t index);

#endif
