#include "navigation/mission.h"

#include <string.h>

void mission_init(mission_t* mission)
{
    memset(mission, 0, sizeof *mission);
}

mission_status_t mission_begin(mission_t* mission, int32_t plan, int32_t count)
{
    if (count < 1 || count > plan_waypoints_max)
    {
        return mission_bad_value;
    }
    mission_init(mission);
    mission->plan = plan;
    mission->count = (size_t)count;
    return mission_ok;
}

static bool is_under_way(const mission_t* mission, int32_t plan)
{
    return mission->count > 0 && mission->plan == plan;
}

mission_status_t mission_item(mission_t* mission, int32_t plan, int32_t index, const waypoint_t* waypoint)
{
    if (!is_under_way(mission, plan))
    {
        return mission_bad_state;
    }
    if (index < 0 || (size_t)index >= mission->count || !waypoint_is_valid(waypoint))
    {
        return mission_bad_value;
    }
    mission->waypoints[index] = *waypoint;
    mission->received[index] = true;
    return mission_ok;
}

mission_status_t mission_commit(mission_t* mission, int32_t plan, plan_t* target)
{
    if (!is_under_way(mission, plan))
    {
        return mission_bad_state;
    }
    for (size_t i = 0; i < mission->count; i++)
    {
        if (!mission->received[i])
        {
            return mission_bad_state;
        }
    }
    if (!plan_replace(target, mission->waypoints, mission->count, false))
    {
        return mission_bad_value;
    }
    mission_init(mission);
    return mission_ok;
}
