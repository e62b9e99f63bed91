#include "navigation/geodesy.h"

#include <math.h>

#include "common/angle.h"

bool position_is_valid(const position_t* position)
{
    return isfinite(position->latitude_deg) && isfinite(position->longitude_deg) &&
           fabs(position->latitude_deg) <= 90.0 && fabs(position->longitude_deg) <= 180.0;
}

/// Difference of two longitudes or latitudes in rad. Taken in double, because a float of degrees resolves no better
/// than a metre or two; the small difference is then exact enough in float.
static float difference_rad(double from_deg, double to_deg)
{
    double difference_deg = to_deg - from_deg;
    if (difference_deg > 180.0)
    {
        difference_deg -= 360.0;
    }
    else if (difference_deg < -180.0)
    {
        difference_deg += 360.0;
    }
    return angle_to_rad((float)difference_deg);
}

float geodesy_distance_m(const position_t* from, const position_t* to)
{
    const float sin_half_latitude = sinf(difference_rad(from->latitude_deg, to->latitude_deg) / 2.0F);
    const float sin_half_longitude = sinf(difference_rad(from->longitude_deg, to->longitude_deg) / 2.0F);
    const float cos_cos = cosf(angle_to_rad((float)from->latitude_deg)) * cosf(angle_to_rad((float)to->latitude_deg));
    const float haversine = sin_half_latitude * sin_half_latitude + cos_cos * sin_half_longitude * sin_half_longitude;
    return 2.0F * GEODESY_RADIUS_M * asinf(sqrtf(fminf(haversine, 1.0F)));
}

float geodesy_bearing_deg(const position_t* from, const position_t* to)
{
    const float latitude_rad = difference_rad(from->latitude_deg, to->latitude_deg);
    const float longitude_rad = difference_rad(from->longitude_deg, to->longitude_deg);
    const float sin_from = sinf(angle_to_rad((float)from->latitude_deg));
    const float cos_to = cosf(angle_to_rad((float)to->latitude_deg));
    const float sin_half_longitude = sinf(longitude_rad / 2.0F);
    const float east = sinf(longitude_rad) * cos_to;
    // equals cos a sin b - sin a cos b cos c, without subtracting two nearly equal numbers
    const float north = sinf(latitude_rad) + 2.0F * sin_from * cos_to * sin_half_longitude * sin_half_longitude;
    if (east == 0.0F && north == 0.0F)
    {
        return 0.0F;
    }
    return angle_wrap_360(angle_to_deg(atan2f(east, north)));
}
