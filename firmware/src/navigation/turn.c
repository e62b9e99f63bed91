#include "navigation/turn.h"

#include <math.h>

#include "common/angle.h"
#include "common/limit.h"
#include "common/units.h"

static const float straight_deg = 2.0F; ///< less is no turn: the field corrects it
// A turn of up to this ends on the next leg. For sharper ones the lead would grow beyond all measure, and the turn pass
// the waypoint too far inside; it shrinks to one radius instead, and the aircraft swings beyond the next leg.
static const float sharp_deg = 115.0F;
static const float sharp_radii = 1.75F; ///< longest lead up to there
static const float sharpest_deg = 150.0F;

turn_t turn_between(float from_deg, float to_deg, const wind_t* wind, float airspeed_m_s, float bank_deg,
                    float roll_time_s)
{
    const float ground_m_s = wind_ground_speed_m_s(wind, airspeed_m_s, from_deg);
    const float side_m_s2 = GRAVITY_M_S2 * tanf(angle_to_rad(bank_deg));
    const float after_m_s = wind_ground_speed_m_s(wind, airspeed_m_s, to_deg);
    const float middle_m_s = 0.5F * (ground_m_s + after_m_s);
    const float fastest_m_s = fmaxf(ground_m_s, after_m_s);
    turn_t turn = {.radius_m = middle_m_s * middle_m_s / side_m_s2};
    const float angle_deg = angle_wrap_180(to_deg - from_deg);
    if (fabsf(angle_deg) < straight_deg)
    {
        return turn;
    }
    const float begin_rad = angle_to_rad(wind_heading_deg(wind, airspeed_m_s, from_deg));
    float turned_rad = angle_to_rad(angle_wrap_180(wind_heading_deg(wind, airspeed_m_s, to_deg))) - begin_rad;
    turned_rad = angle_to_rad(angle_wrap_180(angle_to_deg(turned_rad)));
    const float end_rad = begin_rad + turned_rad;
    const float time_s = fabsf(turned_rad) * airspeed_m_s / side_m_s2;
    const float signed_radius_m = copysignf(airspeed_m_s * airspeed_m_s / side_m_s2, turned_rad);
    const float north_m = signed_radius_m * (sinf(end_rad) - sinf(begin_rad)) + wind->north_m_s * time_s;
    const float east_m = signed_radius_m * (cosf(begin_rad) - cosf(end_rad)) + wind->east_m_s * time_s;
    // the turn ends on the next leg's line: its way across that line equals that of the lead
    const float to_rad = angle_to_rad(to_deg);
    const float across_m = east_m * cosf(to_rad) - north_m * sinf(to_rad);
    const float lead_m = across_m / sinf(angle_to_rad(from_deg - to_deg));
    const float sharpness = limit_to((fabsf(angle_deg) - sharp_deg) / (sharpest_deg - sharp_deg), 0.0F, 1.0F);
    const float longest_m = fastest_m_s * fastest_m_s / side_m_s2 * (sharp_radii + sharpness * (1.0F - sharp_radii));
    turn.is_sharp = sharpness > 0.0F;
    // beyond half a turn the next leg's line lies behind, and its lead is negative
    turn.lead_m = lead_m >= 0.0F ? fminf(lead_m, longest_m) : turn.is_sharp ? longest_m : 0.0F;
    turn.lead_m += ground_m_s * roll_time_s;
    return turn;
}
