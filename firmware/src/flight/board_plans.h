/// The board's two plans, the real aircraft's and the simulated one's: upload, built-in routes, reading back.
#ifndef FLIGHT_BOARD_PLANS_H
#define FLIGHT_BOARD_PLANS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "navigation/mission.h"
#include "navigation/plan.h"

enum
{
    board_plan_flight = 0,
    board_plan_hil = 1,
    board_plan_count = 2
};

typedef struct
{
    plan_t plan[board_plan_count];
    int32_t hil_route;                  ///< which built-in route the HIL plan is; -1: none, or an uploaded plan
    bool is_to_store[board_plan_count]; ///< uploaded, and not yet copied for the card
    mission_t upload;                   ///< under way
    int32_t reading;                    ///< the plan that is being read back, -1: none
    size_t reading_index;               ///< the waypoint that is sent next
} board_plans_t;

/// Both plans empty.
void board_plans_init(board_plans_t* plans);

/// Whether a number from the line is that of a plan.
bool board_plans_has(int32_t plan);

/// Replace `plan` by the waypoints that were uploaded for it, if all are there. `has_card`: it is to be stored.
mission_status_t board_plans_commit(board_plans_t* plans, int32_t plan, bool has_card);

/// Replace the HIL plan by a built-in route (index into `routes`). It is not stored: the board knows it anyway.
bool board_plans_load_route(board_plans_t* plans, int32_t route);

/// Begin to read `plan` back from its first waypoint, or stop reading.
void board_plans_begin_reading(board_plans_t* plans, int32_t plan);
void board_plans_stop_reading(board_plans_t* plans);

/// Whether a plan is being read back.
bool board_plans_is_reading(const board_plans_t* plans);

/// The next waypoint of the plan that is being read back and its index; NULL when no plan is, or it is empty.
const waypoint_t* board_plans_read_next(board_plans_t* plans, size_t* index);

#endif
