/** The WGS84 ellipsoid, metres. */
const EQUATOR_M = 6_378_137;
const FLATTENING = 1 / 298.257223563;
const POLE_RATIO = (1 - FLATTENING) ** 2;
const ECCENTRICITY_SQUARED = 1 - POLE_RATIO;
const RADIANS = Math.PI / 180;

/**
 * Writes a position as earth-centred metres to `into[at..at+2]`: x through the Gulf of Guinea, z through the north
 * pole. The height is above the ellipsoid.
 */
export function writeEcef(
  into: Float64Array,
  at: number,
  latitude_deg: number,
  longitude_deg: number,
  height_m: number,
): void {
  const latitude = latitude_deg * RADIANS;
  const longitude = longitude_deg * RADIANS;
  const sinLatitude = Math.sin(latitude);
  const curvature = EQUATOR_M / Math.sqrt(1 - ECCENTRICITY_SQUARED * sinLatitude * sinLatitude);
  const fromAxis = (curvature + height_m) * Math.cos(latitude);
  into[at] = fromAxis * Math.cos(longitude);
  into[at + 1] = fromAxis * Math.sin(longitude);
  into[at + 2] = (curvature * POLE_RATIO + height_m) * sinLatitude;
}
