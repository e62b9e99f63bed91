import { bearing_deg, destination, distance_m, type Position } from "../../lib/geodesy";

/** Metres east, north and up from a point on the ground. */
export interface Enu {
  readonly east_m: number;
  readonly north_m: number;
  readonly up_m: number;
}

/** The line of sight under the pointer; `direction` has any length but zero. */
export interface Sight {
  readonly origin: Enu;
  readonly direction: Enu;
}

/**
 * Farther along the line of sight than this nothing is placed, metres: just below the horizon a pixel covers a
 * county.
 */
const FARTHEST_M = 200_000;
/** A line of sight flatter than this share of its length is parallel to the plane rather than through it. */
const FLATTEST = 0.002;

/**
 * The point where the line of sight meets the plane at height `up_m`; null if it does not, or only near the horizon.
 */
export function throughLevel({ origin, direction }: Sight, up_m: number): Enu | null {
  const along = Math.hypot(direction.east_m, direction.north_m, direction.up_m);
  if (!(Math.abs(direction.up_m) > FLATTEST * along)) {
    return null;
  }
  const reach = (up_m - origin.up_m) / direction.up_m;
  if (!(reach > 0) || reach * along > FARTHEST_M) {
    return null;
  }
  return {
    east_m: origin.east_m + reach * direction.east_m,
    north_m: origin.north_m + reach * direction.north_m,
    up_m,
  };
}

/**
 * Height, metres, at which the line of sight comes nearest to the vertical through the origin; null if it looks
 * straight down, where no height can be determined.
 */
export function heightAlongVertical({ origin, direction }: Sight): number | null {
  const level = direction.east_m ** 2 + direction.north_m ** 2;
  const along = level + direction.up_m ** 2;
  if (!(level > FLATTEST * along)) {
    return null;
  }
  const reach = -(origin.east_m * direction.east_m + origin.north_m * direction.north_m) / level;
  return reach > 0 ? origin.up_m + reach * direction.up_m : null;
}

/** A closed circle on the ground: the last point is the first. */
export function ring(centre: Position, radius_m: number, corners: number): readonly Position[] {
  const places = Array.from({ length: corners }, (_, index) =>
    destination(centre, (index * 360) / corners, radius_m),
  );
  return [...places, ...places.slice(0, 1)];
}

/** Greatest distance between two points of a drawn leg: a longer straight line would cut through the ground. */
const LEG_STEP_M = 20_000;

export type Point = Position & { readonly altitude_ft: number };

/** The points of a leg along the great circle, both ends among them; the altitude changes evenly. */
export function legPoints(from: Point, to: Point): readonly Point[] {
  const length_m = distance_m(from, to);
  const bearing = bearing_deg(from, to) ?? 0;
  const steps = Math.max(1, Math.ceil(length_m / LEG_STEP_M));
  const inner = Array.from({ length: steps - 1 }, (_, index) => {
    const part = (index + 1) / steps;
    return {
      ...destination(from, bearing, part * length_m),
      altitude_ft: from.altitude_ft + part * (to.altitude_ft - from.altitude_ft),
    };
  });
  return [from, ...inner, to];
}

/** A point on the screen, pixels from the upper left corner. */
export interface Spot {
  readonly x: number;
  readonly y: number;
}

/** Index of the nearest spot within `reach` pixels; null if there is none. An invisible spot is null. */
export function nearest(spots: readonly (Spot | null)[], at: Spot, reach: number): number | null {
  let found: number | null = null;
  let least = reach;
  for (const [index, spot] of spots.entries()) {
    const away = spot === null ? Number.POSITIVE_INFINITY : Math.hypot(spot.x - at.x, spot.y - at.y);
    if (away <= least) {
      found = index;
      least = away;
    }
  }
  return found;
}

/** Pixels from `at` to the line between two spots. */
export function awayFromLine(at: Spot, from: Spot, to: Spot): number {
  const [x, y] = [to.x - from.x, to.y - from.y];
  const square = x * x + y * y;
  const part = square === 0 ? 0 : ((at.x - from.x) * x + (at.y - from.y) * y) / square;
  const along = Math.min(1, Math.max(0, part));
  return Math.hypot(at.x - from.x - along * x, at.y - from.y - along * y);
}
