/// Angles: units and wrapping.
#ifndef COMMON_ANGLE_H
#define COMMON_ANGLE_H

/// Radians of `angle_deg` degrees.
float angle_to_rad(float angle_deg);

/// Degrees of `angle_rad` radians.
float angle_to_deg(float angle_rad);

/// The same direction in [-180, 180). Not finite in, not finite out.
float angle_wrap_180(float angle_deg);

/// The same direction in [0, 360). Not finite in, not finite out.
float angle_wrap_360(float angle_deg);

#endif
