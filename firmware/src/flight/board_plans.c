#include "flight/board_plans.h"

#include <string.h>

#include "navigation/routes_gen.h"

enum
{
    no_route = -1,
    no_plan = -1
};

void board_plans_init(board_plans_t* plans)
{
    memset(plans, 0, sizeof *plans);
    plans->hil_route = no_route;
    plans->reading = no_plan;
    mission_init(&plans->upload);
    for (size_t i = 0; i < board_plan_count; i++)
    {
        plan_clear(&plans->plan[i]);
    }
}

bool board_plans_has(int32_t plan)
{
    return plan >= 0 && plan < board_plan_count;
}

mission_status_t board_plans_commit(board_plans_t* plans, int32_t plan, bool has_card)
{
    const mission_status_t status = mission_commit(&plans->upload, plan, &plans->plan[plan]);
    if (status == mission_ok)
    {
        board_plans_stop_reading(plans);
        plans->is_to_store[plan] = has_card;
        if (plan == board_plan_hil)
        {
            plans->hil_route = no_route;
        }
    }
    return status;
}

bool board_plans_load_route(board_plans_t* plans, int32_t number)
{
    const route_t* const route = &routes[number];
    waypoint_t waypoints[ROUTE_WAYPOINTS_MAX];
    for (size_t i = 0; i < route->count; i++)
    {
        waypoints[i] = (waypoint_t){
            .position = {route->waypoints[i].latitude_deg, route->waypoints[i].longitude_deg},
            .altitude_ft = route->waypoints[i].altitude_ft,
            .speed_kt = route->waypoints[i].speed_kt,
        };
    }
    if (!plan_replace(&plans->plan[board_plan_hil], waypoints, route->count, route->loop))
    {
        return false;
    }
    plans->hil_route = number;
    plans->is_to_store[board_plan_hil] = false;
    board_plans_stop_reading(plans);
    return true;
}

void board_plans_begin_reading(board_plans_t* plans, int32_t plan)
{
    plans->reading = plan;
    plans->reading_index = 0;
}

void board_plans_stop_reading(board_plans_t* plans)
{
    plans->reading = no_plan;
}

bool board_plans_is_reading(const board_plans_t* plans)
{
    return plans->reading != no_plan;
}

const waypoint_t* board_plans_read_next(board_plans_t* plans, size_t* index)
{
    if (!board_plans_is_reading(plans))
    {
        return NULL;
    }
    const plan_t* const plan = &plans->plan[plans->reading];
    *index = plans->reading_index;
    plans->reading_index++;
    if (plans->reading_index >= plan->count)
    {
        board_plans_stop_reading(plans);
    }
    return *index < plan->count ? &plan->waypoints[*index] : NULL;
}
