import { EARTH_RADIUS_M, type Position } from "../../lib/geodesy";
import { roundLength } from "../../lib/scaleBar";

/** Size of a picture, with an empty margin. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly rim: number;
}

/** Projects positions onto the picture: north up, east right. */
export interface Projection {
  readonly centre: Position;
  readonly units_per_m: number;
  readonly picture: Picture;
}

/** Smallest extent of a picture, metres: a single point is not magnified without end. */
const LEAST_SPAN_M = 600;

/**
 * The projection in which all positions lie within the margins; null without positions. Metres are measured along the
 * meridian and the parallel of the middle, accurate for plans of this size.
 */
export function projectionAround(places: readonly Position[], picture: Picture): Projection | null {
  const [first] = places;
  if (first === undefined) {
    return null;
  }
  const latitudes = places.map(({ latitude_deg }) => latitude_deg);
  // Relative to the first, so that a plan across the date line stays together.
  const longitudes = places.map((place) => eastOf(first, place));
  const [south, north] = [Math.min(...latitudes), Math.max(...latitudes)];
  const [west, east] = [Math.min(...longitudes), Math.max(...longitudes)];
  const centre = {
    latitude_deg: (south + north) / 2,
    longitude_deg: first.longitude_deg + (west + east) / 2,
  };
  const tall_m = Math.max(LEAST_SPAN_M, metres(north - south));
  const wide_m = Math.max(LEAST_SPAN_M, metres(east - west) * cosine(centre.latitude_deg));
  const units_per_m = Math.min(
    (picture.width - 2 * picture.rim) / wide_m,
    (picture.height - 2 * picture.rim) / tall_m,
  );
  return { centre, units_per_m, picture };
}

/** A position on the picture: x right, y down. */
export function project(
  { centre, units_per_m, picture }: Projection,
  place: Position,
): { x: number; y: number } {
  const east_m = metres(eastOf(centre, place)) * cosine(centre.latitude_deg);
  const north_m = metres(place.latitude_deg - centre.latitude_deg);
  return { x: picture.width / 2 + east_m * units_per_m, y: picture.height / 2 - north_m * units_per_m };
}

/** The longest bar of 1, 2, 5, 10... metres within this share of the picture. */
export function scaleBar({ units_per_m, picture }: Projection): { length_m: number; units: number } {
  const most_m = (picture.width * 0.3) / units_per_m;
  const length_m = roundLength(most_m);
  return { length_m, units: length_m * units_per_m };
}

/** Degrees of longitude from one place to another, -180..180: the short way. */
function eastOf(from: Position, to: Position): number {
  const east = to.longitude_deg - from.longitude_deg;
  return east > 180 ? east - 360 : east < -180 ? east + 360 : east;
}

function metres(angle_deg: number): number {
  return (angle_deg / 180) * Math.PI * EARTH_RADIUS_M;
}

function cosine(angle_deg: number): number {
  return Math.cos((angle_deg / 180) * Math.PI);
}
