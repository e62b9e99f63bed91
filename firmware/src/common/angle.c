#include "common/angle.h"

#include <math.h>

static const float rad_per_deg = 0.01745329252F;

float angle_to_rad(float angle_deg)
{
    return angle_deg * rad_per_deg;
}

float angle_to_deg(float angle_rad)
{
    return angle_rad / rad_per_deg;
}

float angle_wrap_360(float angle_deg)
{
    const float rest_deg = fmodf(angle_deg, 360.0F);
    const float wrapped_deg = rest_deg < 0.0F ? rest_deg + 360.0F : rest_deg;
    // a tiny negative angle rounds to exactly 360
    return wrapped_deg >= 360.0F ? 0.0F : wrapped_deg;
}

float angle_wrap_180(float angle_deg)
{
    const float wrapped_deg = angle_wrap_360(angle_deg);
    return wrapped_deg >= 180.0F ? wrapped_deg - 360.0F : wrapped_deg;
}
