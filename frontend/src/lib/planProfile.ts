import type { Position } from "./geodesy";
import { legPlace, legsOf, type Waypoint } from "./plan";
import { METRES_PER_FOOT } from "./units";

/** A place along a plan. */
export interface ProfilePlace extends Position {
  /** From the first waypoint, along the plan. */
  readonly along_m: number;
  readonly altitude_ft: number;
  /** The waypoint at the end of its leg. */
  readonly row: number;
}

/** Places along a plan: every waypoint, and between them no farther apart than `step_m`, but no more than `most`. */
export function profilePlaces(
  waypoints: readonly Waypoint[],
  step_m: number,
  most: number,
): readonly ProfilePlace[] {
  const legs = legsOf(waypoints);
  const total_m = legs.reduce((sum, { distance_m }) => sum + distance_m, 0);
  const apart_m = Math.max(step_m, total_m / Math.max(1, most - waypoints.length));
  let along_m = 0;
  return waypoints.flatMap((to, row) => {
    const from = waypoints[row - 1];
    const length_m = legs[row - 1]?.distance_m ?? 0;
    const start_m = along_m;
    along_m += length_m;
    const here = { ...placeOf(to), along_m, altitude_ft: to.altitude_ft, row };
    if (from === undefined) {
      return [here];
    }
    const pieces = Math.max(1, Math.ceil(length_m / apart_m));
    const between = Array.from({ length: pieces - 1 }, (_, index) => {
      const share = (index + 1) / pieces;
      return {
        ...legPlace(from, to, share),
        along_m: start_m + share * length_m,
        altitude_ft: from.altitude_ft + share * (to.altitude_ft - from.altitude_ft),
        row,
      };
    });
    return [...between, here];
  });
}

function placeOf({ latitude_deg, longitude_deg }: Position): Position {
  return { latitude_deg, longitude_deg };
}

/** The ground's height below each place, metres above the sea; null: not known. */
export type Heights = readonly (number | null)[];

export interface Clearance {
  /** The least height above the ground where the ground is known; null: nowhere. */
  readonly least: { readonly clearance_ft: number; readonly along_m: number; readonly row: number } | null;
  /** Share of the places whose ground is not known, 0..1. */
  readonly unknown: number;
  /** Legs, by the row of their end, that come nearer to the ground than wanted; the least of each. */
  readonly low: ReadonlyArray<{ readonly row: number; readonly clearance_ft: number }>;
}

/** How high a plan is above the ground, and which of its legs come nearer to it than `wanted_ft`. */
export function clearanceOf(
  places: readonly ProfilePlace[],
  heights_m: Heights,
  wanted_ft: number,
): Clearance {
  let least: Clearance["least"] = null;
  let unknown = 0;
  const low = new Map<number, number>();
  for (const [index, { along_m, altitude_ft, row }] of places.entries()) {
    const height_m = heights_m[index] ?? null;
    if (height_m === null) {
      unknown += 1;
    } else {
      const clearance_ft = altitude_ft - height_m / METRES_PER_FOOT;
      if (least === null || clearance_ft < least.clearance_ft) {
        least = { clearance_ft, along_m, row };
      }
      if (clearance_ft < wanted_ft) {
        low.set(row, Math.min(clearance_ft, low.get(row) ?? clearance_ft));
      }
    }
  }
  return {
    least,
    unknown: places.length === 0 ? 0 : unknown / places.length,
    low: [...low].map(([row, clearance_ft]) => ({ row, clearance_ft })),
  };
}
