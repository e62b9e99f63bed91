import { bearing_deg, destination, distance_m, type Position } from "./geodesy";
import { turnRadius_m, type Waypoint } from "./plan";
import { DEGREES_PER_RADIAN, wrap180 } from "./units";

/** How the line law flies past a waypoint in calm air. */
export interface Turn {
  /** Where it circles over to the next leg; empty where that goes straight on, or where none follows. */
  readonly arc: readonly Position[];
  /** The ends of the line at which the waypoint counts as reached: across the leg, or halfway through the turn. */
  readonly capture: readonly [Position, Position];
}

/** Less is no turn: the law corrects it on the leg. */
const STRAIGHT_DEG = 2;
/** Up to here a turn ends on the next leg; for sharper ones the lead shrinks to one radius, and it swings out. */
const SHARP_DEG = 115;
const SHARPEST_DEG = 150;
const LONGEST_RADII = 1.75;
const ARC_STEP_DEG = 6;

/** The turn at `at`, flown at its speed and this bank; null where no leg leads to it. As `navigation/turn.c` leads it. */
export function turnAt(
  before: Position,
  at: Waypoint,
  after: Position | null,
  bank_deg: number,
): Turn | null {
  // The course of the leg's end, which differs from that of its beginning on a great circle.
  const back = bearing_deg(at, before);
  if (back === null) {
    return null;
  }
  const course = back + 180;
  const next = after === null ? null : bearing_deg(at, after);
  const change_deg = next === null ? 0 : wrap180(next - course);
  const radius = turnRadius_m(at.speed_kt, bank_deg);
  const across = course + change_deg / 2 + 90;
  const capture = [destination(at, across, -radius), destination(at, across, radius)] as const;
  if (Math.abs(change_deg) < STRAIGHT_DEG) {
    return { arc: [], capture };
  }
  const begin = destination(at, back, Math.min(lead_m(change_deg, radius), distance_m(before, at)));
  const side = change_deg > 0 ? 90 : -90;
  const centre = destination(begin, course + side, radius);
  const steps = Math.ceil(Math.abs(change_deg) / ARC_STEP_DEG);
  const arc = Array.from({ length: steps + 1 }, (_, step) =>
    destination(centre, course - side + (change_deg * step) / steps, radius),
  );
  return { arc, capture };
}

function lead_m(change_deg: number, radius: number): number {
  const sharpness = (Math.abs(change_deg) - SHARP_DEG) / (SHARPEST_DEG - SHARP_DEG);
  const most = LONGEST_RADII + Math.min(1, Math.max(0, sharpness)) * (1 - LONGEST_RADII);
  return radius * Math.min(Math.tan(Math.abs(change_deg) / 2 / DEGREES_PER_RADIAN), most);
}
