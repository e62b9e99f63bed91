/// The board as the sum of its parts. Each part is a structure that its own file owns and changes; only the board
/// itself (`board.c`), its commands and its streams see more than one of them.
#ifndef FLIGHT_BOARD_STATE_H
#define FLIGHT_BOARD_STATE_H

#include <stdbool.h>
#include <stdint.h>

#include "comms/telemetry.h"
#include "flight/board_card.h"
#include "flight/board_plans.h"
#include "flight/description.h"
#include "flight/flight_loop.h"
#include "flight/hil_loop.h"
#include "flight/measurements.h"
#include "flight/own_topics.h"
#include "flight/reports.h"
#include "flight/servo_outputs.h"
#include "flight/tuning.h"

#define BOARD_FIRMWARE_NAME "epf-board"
#define BOARD_FIRMWARE_VERSION "1.0.0"

/// What the board knows of the station and its line.
typedef struct
{
    bool is_extended;   ///< it has asked for capabilities since it opened the line
    bool wants_steps;   ///< it has asked for the times of HIL steps since then
    uint32_t status_ms; ///< when the last board status was sent to it
    uint32_t frames_received;
    uint32_t frames_rejected;
} board_station_t;

typedef struct
{
    bool is_legacy;              ///< like a deployed board: no extension exists
    description_summary_t table; ///< that the board describes itself by
    description_reading_t reading;
    own_topics_t own_topics;
    measurements_t measured;
    tuning_t tuning;
    board_plans_t plans;
    flight_loop_t flight;
    hil_loop_t hil;
    servo_outputs_t servos;
    board_card_t card;
    board_station_t station;
    telemetry_schedule_t schedule;
    report_line_t line;
} board_t;

#endif
