#include "navigation/leg.h"

#include <math.h>

#include "common/angle.h"

static const float shortest_m = 1.0F; ///< the positions of the wire resolve no direction of less

offset_t leg_offset_m(const position_t* origin, const position_t* place)
{
    const float shrink = cosf(angle_to_rad((float)origin->latitude_deg));
    double longitude_deg = place->longitude_deg - origin->longitude_deg;
    if (longitude_deg > 180.0)
    {
        longitude_deg -= 360.0;
    }
    else if (longitude_deg < -180.0)
    {
        longitude_deg += 360.0;
    }
    return (offset_t){
        .north_m = (float)((place->latitude_deg - origin->latitude_deg) * GEODESY_M_PER_DEG),
        .east_m = (float)(longitude_deg * GEODESY_M_PER_DEG) * shrink,
    };
}

leg_t leg_between(const position_t* begin, const position_t* end, float course_deg)
{
    const offset_t back = leg_offset_m(end, begin);
    leg_t leg = {.end = *end, .length_m = hypotf(back.north_m, back.east_m)};
    if (leg.length_m >= shortest_m)
    {
        leg.north = -back.north_m / leg.length_m;
        leg.east = -back.east_m / leg.length_m;
        leg.course_deg = angle_wrap_360(angle_to_deg(atan2f(leg.east, leg.north)));
    }
    else
    {
        leg.course_deg = angle_wrap_360(course_deg);
        leg.north = cosf(angle_to_rad(leg.course_deg));
        leg.east = sinf(angle_to_rad(leg.course_deg));
    }
    return leg;
}

leg_place_t leg_place(const leg_t* leg, const position_t* position)
{
    const offset_t from_end = leg_offset_m(&leg->end, position);
    return (leg_place_t){
        .remaining_m = -(from_end.north_m * leg->north + from_end.east_m * leg->east),
        .right_m = from_end.east_m * leg->north - from_end.north_m * leg->east,
    };
}
