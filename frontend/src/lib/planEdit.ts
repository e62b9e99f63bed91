import { bearing_deg, destination, distance_m, type Position } from "./geodesy";
import { FIRST_WAYPOINT, legPlace, type Push, placed, pushed, rounded, type Waypoint } from "./plan";

/** Edits of a plan that come from a place on the map, or that concern several waypoints at once. */

/** The plan with a new last waypoint at a place; altitude and speed are those of the one before. */
export function appended(waypoints: readonly Waypoint[], place: Position): readonly Waypoint[] {
  const { altitude_ft, speed_kt } = waypoints.at(-1) ?? FIRST_WAYPOINT;
  return [...waypoints, rounded({ ...onEarth(place), altitude_ft, speed_kt })];
}

/**
 * The plan with a new waypoint before `row`, at a place. Its altitude is on the straight line of the leg; a waypoint
 * before the first has the first one's altitude, one after the last the last one's.
 */
export function insertedAt(
  waypoints: readonly Waypoint[],
  row: number,
  place: Position,
): readonly Waypoint[] {
  const before = waypoints[row - 1];
  const after = waypoints[row];
  if (after === undefined) {
    return appended(waypoints, place);
  }
  const altitude_ft = before === undefined ? after.altitude_ft : between(before, after, place);
  return waypoints.toSpliced(row, 0, rounded({ ...onEarth(place), altitude_ft, speed_kt: after.speed_kt }));
}

function between(before: Waypoint, after: Waypoint, place: Position): number {
  const [from_m, to_m] = [distance_m(before, place), distance_m(place, after)];
  const share = from_m + to_m === 0 ? 0.5 : from_m / (from_m + to_m);
  return before.altitude_ft + share * (after.altitude_ft - before.altitude_ft);
}

/** The plan with a waypoint on the leg that ends at `row`, at `share` (0..1) of its length. */
export function insertedOnLeg(
  waypoints: readonly Waypoint[],
  row: number,
  share: number,
): readonly Waypoint[] {
  const from = waypoints[row - 1] ?? waypoints.at(-1);
  const to = waypoints[row];
  return from === undefined || to === undefined
    ? waypoints
    : insertedAt(waypoints, row, legPlace(from, to, share));
}

/**
 * The row before which a waypoint at `place` makes the plan longest by the least: where a person would put it. One
 * after the last row means at the end.
 */
export function bestRow(waypoints: readonly Waypoint[], place: Position): number {
  const last = waypoints.at(-1);
  if (last === undefined) {
    return 0;
  }
  let best = waypoints.length;
  let least_m = distance_m(last, place);
  for (const [index, to] of waypoints.entries()) {
    const from = waypoints[index - 1];
    const detour_m =
      from === undefined
        ? distance_m(place, to)
        : distance_m(from, place) + distance_m(place, to) - distance_m(from, to);
    if (detour_m < least_m) {
      best = index;
      least_m = detour_m;
    }
  }
  return best;
}

/** The plan flown the other way round: each altitude stays with its place, each speed with its leg. */
export function reversed(waypoints: readonly Waypoint[]): readonly Waypoint[] {
  const first = waypoints[0];
  // A speed belongs to the way to its waypoint: the leg from 1 to 2 is flown at the speed of 2, also backwards.
  return first === undefined
    ? waypoints
    : waypoints.toReversed().map((waypoint, index) => ({
        ...waypoint,
        speed_kt: (index === 0 ? first : (waypoints[waypoints.length - index] ?? first)).speed_kt,
      }));
}

/** The plan without some of its waypoints. */
export function without(waypoints: readonly Waypoint[], rows: readonly number[]): readonly Waypoint[] {
  return rows.some((row) => waypoints[row] !== undefined)
    ? waypoints.filter((_, row) => !rows.includes(row))
    : waypoints;
}

/** The plan with these waypoints displaced alike. */
export function shifted(
  waypoints: readonly Waypoint[],
  rows: readonly number[],
  by: Push,
): readonly Waypoint[] {
  return rows.reduce((plan, row) => pushed(plan, row, by), waypoints);
}

/** These waypoints at another speed. */
export function withSpeed(
  waypoints: readonly Waypoint[],
  rows: readonly number[],
  speed_kt: number,
): readonly Waypoint[] {
  return waypoints.map((waypoint, row) => (rows.includes(row) ? { ...waypoint, speed_kt } : waypoint));
}

/**
 * The plan with waypoint `row` put to another place. Where it is one of several selected ones, the others move by the
 * same distance and bearing, and by the same change of altitude.
 */
export function carried(
  waypoints: readonly Waypoint[],
  row: number,
  to: Position & { readonly altitude_ft: number },
  rows: readonly number[],
): readonly Waypoint[] {
  const from = waypoints[row];
  const put = placed(waypoints, row, to);
  if (from === undefined || !rows.includes(row) || rows.length < 2) {
    return put;
  }
  const away_m = distance_m(from, to);
  const course_deg = bearing_deg(from, to) ?? 0;
  const up_ft = to.altitude_ft - from.altitude_ft;
  return put.map((waypoint, index) => {
    if (index === row || !rows.includes(index)) {
      return waypoint;
    }
    const place = away_m === 0 ? waypoint : destination(waypoint, course_deg, away_m);
    return placed([waypoint], 0, { ...place, altitude_ft: waypoint.altitude_ft + up_ft })[0] ?? waypoint;
  });
}

/** A click on the map may carry more than a position. */
function onEarth({ latitude_deg, longitude_deg }: Position): Position {
  return { latitude_deg, longitude_deg };
}
