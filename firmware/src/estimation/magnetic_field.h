/// The earth's magnetic field by place: the World Magnetic Model 2025 at sea level, in the middle of its five years.
///
/// From the middle to either end of those years the declination moves by up to 0.5 deg in the Canary Islands, and by
/// up to 1.2 deg where the horizontal field is above 10,000 nT; up to an aircraft's altitude by some hundredths.
#ifndef ESTIMATION_MAGNETIC_FIELD_H
#define ESTIMATION_MAGNETIC_FIELD_H

#include <stdbool.h>

#include "estimation/rotation.h"

/// The field where the aircraft is. All zeros: the place is not known yet.
typedef struct
{
    bool is_known;
    float latitude_deg;
    float longitude_deg;
    vector_t field_nt; ///< north, east, down
} magnetic_field_t;

/// North, east and down in nT at a latitude (north positive, -90..90) and a longitude (east positive) in deg.
vector_t magnetic_field_at(float latitude_deg, float longitude_deg);

/// Follow the aircraft: the field is computed again only after some kilometres.
void magnetic_field_move(magnetic_field_t* magnetic, float latitude_deg, float longitude_deg);

/// Angle from true to magnetic north, east positive, in deg; NaN while the place is not known.
float magnetic_field_declination_deg(const magnetic_field_t* magnetic);

#endif
