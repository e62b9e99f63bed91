import type { Position } from "./geodesy";
import { FIRST_WAYPOINT, type Waypoint } from "./plan";

/** A plan with one more waypoint, to which the board is then sent. */
export interface FlownHere {
  readonly waypoints: readonly Waypoint[];
  readonly row: number;
}

/** What follows on it: the waypoint that was flown to, or circles, because the last waypoint is held. */
export type Afterwards = "goOn" | "stay";

/**
 * The plan with a waypoint at `place` before the one that is flown to (`goOn`) or behind all others (`stay`). `row` is
 * that of the waypoint which is flown to now; null if it is not known: then there is nothing to go on to.
 */
export function flownHere(
  waypoints: readonly Waypoint[],
  row: number | null,
  { latitude_deg, longitude_deg }: Position,
  altitude_ft: number,
  afterwards: Afterwards,
): FlownHere | null {
  const at = afterwards === "stay" ? waypoints.length : row;
  if (at === null) {
    return null;
  }
  const { speed_kt } = target(waypoints, row);
  const added: Waypoint = {
    latitude_deg: Number(latitude_deg.toFixed(6)),
    longitude_deg: Number(longitude_deg.toFixed(6)),
    altitude_ft,
    speed_kt,
  };
  return { waypoints: waypoints.toSpliced(at, 0, added), row: at };
}

/** The waypoint whose altitude and speed a new one takes: the one that is flown to, else the last. */
export function target(waypoints: readonly Waypoint[], row: number | null): Waypoint {
  return (row === null ? undefined : waypoints[row]) ?? waypoints.at(-1) ?? FIRST_WAYPOINT;
}
