import { DEGREES_PER_RADIAN, wrap180, wrap360 } from "./units";

/** A position: north and east are positive, degrees. */
export interface Position {
  readonly latitude_deg: number;
  readonly longitude_deg: number;
}

/** Mean radius of the earth, metres: the sphere on which the board computes its distances too. */
export const EARTH_RADIUS_M = 6_371_008.8;
/** Of latitude, on that sphere: 111,195 m. */
export const METRES_PER_DEGREE = EARTH_RADIUS_M / DEGREES_PER_RADIAN;

/** Great-circle distance in metres, by the haversine: exact for points that nearly coincide. */
export function distance_m(from: Position, to: Position): number {
  const sinHalfLatitude = Math.sin(radians(to.latitude_deg - from.latitude_deg) / 2);
  const sinHalfLongitude = Math.sin(radians(to.longitude_deg - from.longitude_deg) / 2);
  const cosines = Math.cos(radians(from.latitude_deg)) * Math.cos(radians(to.latitude_deg));
  const haversine = sinHalfLatitude ** 2 + cosines * sinHalfLongitude ** 2;
  return 2 * EARTH_RADIUS_M * Math.asin(Math.sqrt(Math.min(1, haversine)));
}

/** Initial bearing of the great circle from `from`, 0..360 clockwise from north; null if both positions coincide. */
export function bearing_deg(from: Position, to: Position): number | null {
  const latitude = radians(to.latitude_deg - from.latitude_deg);
  const longitude = radians(to.longitude_deg - from.longitude_deg);
  const cosTo = Math.cos(radians(to.latitude_deg));
  const east = Math.sin(longitude) * cosTo;
  // cos a sin b - sin a cos b cos c, without the difference of two nearly equal numbers.
  const north =
    Math.sin(latitude) + 2 * Math.sin(radians(from.latitude_deg)) * cosTo * Math.sin(longitude / 2) ** 2;
  return east === 0 && north === 0 ? null : wrap360(Math.atan2(east, north) * DEGREES_PER_RADIAN);
}

/** The position `distance` metres from `from` along the great circle with this initial bearing. */
export function destination(from: Position, bearing: number, distance: number): Position {
  const angle = distance / EARTH_RADIUS_M;
  const latitude = radians(from.latitude_deg);
  const course = radians(bearing);
  const sinTo =
    Math.sin(latitude) * Math.cos(angle) + Math.cos(latitude) * Math.sin(angle) * Math.cos(course);
  const longitude = Math.atan2(
    Math.sin(course) * Math.sin(angle) * Math.cos(latitude),
    Math.cos(angle) - Math.sin(latitude) * sinTo,
  );
  return {
    latitude_deg: Math.asin(Math.max(-1, Math.min(1, sinTo))) * DEGREES_PER_RADIAN,
    longitude_deg: wrap180(from.longitude_deg + longitude * DEGREES_PER_RADIAN),
  };
}

function radians(angle_deg: number): number {
  return angle_deg / DEGREES_PER_RADIAN;
}
