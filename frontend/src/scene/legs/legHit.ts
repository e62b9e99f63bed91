import type { Aircraft } from "../../lib/aircraft";
import { legPlace } from "../../lib/plan";
import { awayFromLine, type Point, type Spot } from "./geometry";
import { type DrawnPlan, drawnLegs } from "./shape";

/** A place on a plan's leg. */
export interface LegPlace {
  readonly plan: Aircraft;
  /** Index of the waypoint at its end. */
  readonly row: number;
  /** How far along, 0..1. */
  readonly share: number;
}

/** A leg is drawn as a curve on the globe: it is looked at in so many pieces. */
const PIECES = 24;

/** The place nearest to `at` on a plan's legs, within `reach_px` on the screen; null if there is none. */
export function legAt(
  plan: Aircraft,
  drawn: DrawnPlan,
  spotOf: (point: Point) => Spot | null,
  at: Spot,
  reach_px: number,
): LegPlace | null {
  let found: LegPlace | null = null;
  let least_px = reach_px;
  for (const { from, to, row } of drawnLegs(drawn)) {
    let before: Spot | null = null;
    for (let piece = 0; piece <= PIECES; piece += 1) {
      const share = piece / PIECES;
      const altitude_ft = from.altitude_ft + share * (to.altitude_ft - from.altitude_ft);
      const spot = spotOf({ ...legPlace(from, to, share), altitude_ft });
      if (before !== null && spot !== null) {
        const away_px = awayFromLine(at, before, spot);
        if (away_px <= least_px) {
          least_px = away_px;
          found = { plan, row, share: (piece - 1 + along(at, before, spot)) / PIECES };
        }
      }
      before = spot;
    }
  }
  return found;
}

/** The share, 0..1, of the line between two spots that is nearest to `at`. */
function along(at: Spot, from: Spot, to: Spot): number {
  const [x, y] = [to.x - from.x, to.y - from.y];
  const square = x * x + y * y;
  const share = square === 0 ? 0 : ((at.x - from.x) * x + (at.y - from.y) * y) / square;
  return Math.min(1, Math.max(0, share));
}
