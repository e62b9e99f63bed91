/// The frames that the board sends, one function for each. A function is given the values of its frame and knows
/// nothing else of the board.
#ifndef FLIGHT_REPORTS_H
#define FLIGHT_REPORTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "comms/command.h"
#include "comms/protocol_gen.h"
#include "control/surfaces.h"
#include "flight/board_sensors.h"
#include "flight/description.h"
#include "navigation/plan.h"
#include "params/parameters.h"

/// Hand one complete frame to the line.
typedef void (*board_send_fn_t)(void* context, const uint8_t* frame, size_t size);

/// Whether the line has all but caught up: a frame that is handed to it now leaves the board almost at once.
typedef bool (*board_line_is_idle_fn_t)(const void* context);

/// Where frames go.
typedef struct
{
    board_send_fn_t send;
    board_line_is_idle_fn_t is_idle; ///< NULL: always
    void* context;
} report_line_t;

void report_heartbeat(const report_line_t* line, const message_heartbeat_t* values);
void report_ahrs(const report_line_t* line, const message_ahrs_t* values);
void report_inertial(const report_line_t* line, const message_inertial_t* values);
void report_analog(const report_line_t* line, const message_analog_t* values);
void report_statistics(const report_line_t* line, const message_statistics_t* values);
void report_gps(const report_line_t* line, const message_gps_t* values);
void report_servos_in(const report_line_t* line, const message_servos_in_t* values);

/// What `plan` asks for, seen from `position` at `speed_kt`. `type_id`: types 6 and 7 (the real and the simulated
/// aircraft's) have one layout.
void report_plan(const report_line_t* line, uint32_t type_id, const plan_t* plan, const position_t* position,
                 float speed_kt);

void report_fly_by_wire(const report_line_t* line, const surfaces_t* surfaces);
void report_hil_surfaces(const report_line_t* line, const surfaces_t* surfaces);
/// When, and by how much, the HIL loop was stepped for the surfaces that were sent just now.
void report_hil_step(const report_line_t* line, uint32_t clock_ms, float step_s);
/// Size and CRC-32 of the table in which the board describes itself.
void report_description(const report_line_t* line, const description_summary_t* summary);
/// A block of it.
void report_description_block(const report_line_t* line, size_t block, const uint8_t bytes[description_block_bytes]);
/// A topic of the board's own, whose payload is made already.
void report_own_topic(const report_line_t* line, uint32_t type_id, const uint8_t* payload, size_t size);
/// The value of an own gain, by its row.
void report_own_gain(const report_line_t* line, size_t row, float value);
void report_parameters(const report_line_t* line, const parameters_t* parameters);
void report_capabilities(const report_line_t* line, const message_capabilities_t* values);
void report_acknowledgement(const report_line_t* line, uint32_t type_id, command_result_t result);
void report_status(const report_line_t* line, const message_board_status_t* values);
void report_mission_count(const report_line_t* line, int32_t plan, size_t count);
void report_mission_item(const report_line_t* line, int32_t plan, size_t index, const waypoint_t* waypoint);

#endif
