import { bearing_deg, destination, distance_m, type Position } from "./geodesy";
import { convertUnit, DEGREES_PER_RADIAN } from "./units";

/** One point of a flight plan: altitude above mean sea level, and the indicated airspeed on the way to it. */
export interface Waypoint extends Position {
  readonly altitude_ft: number;
  readonly speed_kt: number;
}

export const WAYPOINT_FIELDS = ["latitude_deg", "longitude_deg", "altitude_ft", "speed_kt"] as const;
export type WaypointField = (typeof WAYPOINT_FIELDS)[number];

/** The leg from a waypoint to the next. */
export interface Leg {
  readonly distance_m: number;
  /** Null if both positions coincide. */
  readonly bearing_deg: number | null;
  /** Up is positive. */
  readonly climb_ft: number;
  /** Climb angle of the straight line, up is positive; ±90 if both positions coincide. */
  readonly climb_deg: number;
}

/** The legs of a plan: one less than it has waypoints. */
export function legsOf(waypoints: readonly Waypoint[]): readonly Leg[] {
  return waypoints.slice(1).map((to, index) => legBetween(waypoints[index] ?? to, to));
}

function legBetween(from: Waypoint, to: Waypoint): Leg {
  const distance = distance_m(from, to);
  const climb_ft = to.altitude_ft - from.altitude_ft;
  return {
    distance_m: distance,
    bearing_deg: bearing_deg(from, to),
    climb_ft,
    climb_deg: Math.atan2(convertUnit(climb_ft, "ft", "m"), distance) * DEGREES_PER_RADIAN,
  };
}

/** Standard gravity, m/s². */
const GRAVITY_M_S2 = 9.80665;
const CAPTURE_MINIMUM_M = 200;
const CAPTURE_MINIMUM_TO_KT = 55;
const STEEPEST_BANK_DEG = 30;

/**
 * Distance, metres, at which the board counts a waypoint as reached: 200 up to 55 kt, above that one and a half radii
 * of its steepest turn.
 */
export function captureRadius_m(speed_kt: number): number {
  if (!(speed_kt > CAPTURE_MINIMUM_TO_KT)) {
    return CAPTURE_MINIMUM_M;
  }
  return Math.max(CAPTURE_MINIMUM_M, 1.5 * turnRadius_m(speed_kt, STEEPEST_BANK_DEG));
}

/** Radius of a level turn in calm air, metres. */
export function turnRadius_m(speed_kt: number, bank_deg: number): number {
  return convertUnit(speed_kt, "kt", "mPerS") ** 2 / (GRAVITY_M_S2 * Math.tan(bank_deg / DEGREES_PER_RADIAN));
}

/** Whether both plans are the same for the board, which stores positions in double and the rest in single precision. */
export function samePlan(one: readonly Waypoint[], other: readonly Waypoint[]): boolean {
  return one.length === other.length && one.every((waypoint, index) => sameWaypoint(waypoint, other[index]));
}

/** For each waypoint, whether it differs from the board's in the same place; if the board's plan is unknown, all do. */
export function unsentOf(
  waypoints: readonly Waypoint[],
  board: readonly Waypoint[] | null,
): readonly boolean[] {
  return waypoints.map((waypoint, index) => board === null || !sameWaypoint(waypoint, board[index]));
}

/**
 * Row of the edited plan to which a board goes on that flies to row `flownTo` of its own: the same waypoint, nearest to
 * where it was; else the one that has its number. Null where the plan ends before that.
 */
export function sameRow(
  waypoints: readonly Waypoint[],
  board: readonly Waypoint[] | null,
  flownTo: number,
): number | null {
  const sought = board?.[flownTo];
  const rows = [...waypoints.keys()]
    .filter((row) => sought !== undefined && sameWaypoint(sought, waypoints[row]))
    .sort((one, other) => Math.abs(one - flownTo) - Math.abs(other - flownTo));
  return rows[0] ?? (flownTo < waypoints.length ? flownTo : null);
}

function sameWaypoint(waypoint: Waypoint, twin: Waypoint | undefined): boolean {
  return (
    twin !== undefined &&
    waypoint.latitude_deg === twin.latitude_deg &&
    waypoint.longitude_deg === twin.longitude_deg &&
    Math.fround(waypoint.altitude_ft) === Math.fround(twin.altitude_ft) &&
    Math.fround(waypoint.speed_kt) === Math.fround(twin.speed_kt)
  );
}

/** A first waypoint: the start's position and altitude, the usual aircraft's speed. */
export const FIRST_WAYPOINT: Waypoint = {
  latitude_deg: 27.9319,
  longitude_deg: -15.3866,
  altitude_ft: 1000,
  speed_kt: 55,
};
/** Distance of a new last waypoint from the one before, metres. */
const AHEAD_M = 1000;

/** The plan with a new waypoint after `index` (-1: before the first): half way to the next, or straight ahead. */
export function inserted(waypoints: readonly Waypoint[], index: number): readonly Waypoint[] {
  const before = waypoints[index];
  const after = waypoints[index + 1];
  let added: Waypoint;
  if (before !== undefined && after !== undefined) {
    const leg = legBetween(before, after);
    added = {
      ...destination(before, leg.bearing_deg ?? 0, leg.distance_m / 2),
      altitude_ft: (before.altitude_ft + after.altitude_ft) / 2,
      speed_kt: after.speed_kt,
    };
  } else if (before !== undefined) {
    const earlier = waypoints[index - 1];
    const bearing = earlier === undefined ? null : bearing_deg(earlier, before);
    added = { ...before, ...destination(before, bearing ?? 0, AHEAD_M) };
  } else {
    added = after === undefined ? FIRST_WAYPOINT : { ...after, ...destination(after, 180, AHEAD_M) };
  }
  return waypoints.toSpliced(index + 1, 0, rounded(added));
}

export function removed(waypoints: readonly Waypoint[], index: number): readonly Waypoint[] {
  return waypoints.filter((_, other) => other !== index);
}

/** The plan with one waypoint a place earlier or later; unchanged at the end. */
export function moved(waypoints: readonly Waypoint[], index: number, by: -1 | 1): readonly Waypoint[] {
  const one = waypoints[index];
  const other = waypoints[index + by];
  return one === undefined || other === undefined
    ? waypoints
    : waypoints.with(index, other).with(index + by, one);
}

export function changed(
  waypoints: readonly Waypoint[],
  index: number,
  field: WaypointField,
  value: number,
): readonly Waypoint[] {
  const waypoint = waypoints[index];
  return waypoint === undefined || waypoint[field] === value
    ? waypoints
    : waypoints.with(index, { ...waypoint, [field]: value });
}

/** A displacement of a waypoint: metres to the north and east, feet upwards. */
export interface Push {
  readonly north_m?: number;
  readonly east_m?: number;
  readonly up_ft?: number;
}

/** The plan with one waypoint displaced; unchanged if there is no such waypoint. */
export function pushed(
  waypoints: readonly Waypoint[],
  index: number,
  { north_m = 0, east_m = 0, up_ft = 0 }: Push,
): readonly Waypoint[] {
  const waypoint = waypoints[index];
  if (waypoint === undefined) {
    return waypoints;
  }
  const away_m = Math.hypot(north_m, east_m);
  const place =
    away_m === 0 ? waypoint : destination(waypoint, Math.atan2(east_m, north_m) * DEGREES_PER_RADIAN, away_m);
  const { latitude_deg, longitude_deg } = place;
  return placed(waypoints, index, {
    latitude_deg,
    longitude_deg,
    altitude_ft: waypoint.altitude_ft + up_ft,
  });
}

/** The plan with one waypoint put to another position, rounded to the usual precision. */
export function placed(
  waypoints: readonly Waypoint[],
  index: number,
  to: Position & { readonly altitude_ft: number },
): readonly Waypoint[] {
  const waypoint = waypoints[index];
  if (waypoint === undefined) {
    return waypoints;
  }
  const put = rounded({ ...waypoint, ...to });
  const isMoved = to.latitude_deg !== waypoint.latitude_deg || to.longitude_deg !== waypoint.longitude_deg;
  const { latitude_deg, longitude_deg } = isMoved ? put : waypoint;
  const { altitude_ft } = to.altitude_ft === waypoint.altitude_ft ? waypoint : put;
  return waypoints.with(index, { ...waypoint, latitude_deg, longitude_deg, altitude_ft });
}

/** The place at `share` (0..1) of the great circle between two places. */
export function legPlace(from: Position, to: Position, share: number): Position {
  return destination(from, bearing_deg(from, to) ?? 0, share * distance_m(from, to));
}

/** Rounded to the usual precision: 0.1 m, whole feet. */
export function rounded({ latitude_deg, longitude_deg, altitude_ft, speed_kt }: Waypoint): Waypoint {
  return {
    latitude_deg: Number(latitude_deg.toFixed(6)),
    longitude_deg: Number(longitude_deg.toFixed(6)),
    altitude_ft: Math.round(altitude_ft),
    speed_kt,
  };
}
