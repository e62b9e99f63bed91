/// Altitude and airspeed from pressures, in the international standard atmosphere (ISA, below 11 km).
#ifndef ESTIMATION_AIR_H
#define ESTIMATION_AIR_H

/// Pressure altitude: height in the standard atmosphere, whose sea level has 1013.25 hPa. `static_pa` > 0.
float air_altitude_m(float static_pa);

/// Calibrated airspeed of a Pitot tube's pressure above the static one. At rest, noise makes that pressure
/// slightly negative at times; the airspeed is negative then, too, so that its mean is 0.
float air_calibrated_speed_m_s(float pitot_pa);

/// True airspeed, at the standard density of that static pressure. `static_pa` > 0.
float air_true_speed_m_s(float calibrated_m_s, float static_pa);

#endif
