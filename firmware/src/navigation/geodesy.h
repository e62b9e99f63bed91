/// Great circles on a sphere with the mean radius of the earth. Latitude north +, longitude east +, in deg.
#ifndef NAVIGATION_GEODESY_H
#define NAVIGATION_GEODESY_H

#include <stdbool.h>

#define GEODESY_RADIUS_M 6371008.8F
#define GEODESY_M_PER_DEG 111195.08 ///< of latitude

typedef struct
{
    double latitude_deg;
    double longitude_deg;
} position_t;

/// True when both are finite and inside of +-90 and +-180.
bool position_is_valid(const position_t* position);

/// Distance in m.
float geodesy_distance_m(const position_t* from, const position_t* to);

/// Initial true bearing in [0, 360) deg; 0 when both are the same place.
float geodesy_bearing_deg(const position_t* from, const position_t* to);

#endif
