import { wrap360 } from "../../lib/units";
import { digitsPath } from "../dial/digits";
import { clamp, isDrawable, round, series, tickPath } from "../dial/scale";

/**
 * Attitude of the airframe against local north-east-down: pitch nose up is positive, roll right wing down is
 * positive, both in degrees. `null` is not measured.
 */
export interface Attitude {
  readonly pitch_deg: number | null;
  readonly roll_deg: number | null;
}

/** Picture units that the horizon moves for a degree of pitch. */
export const UNITS_PER_DEGREE = 2.3;

/** Radius of the ball, and of the part of it that the pitch ladder may use. */
export const BALL_RADIUS = 91.5;
export const LADDER_RADIUS = 64;

/** The horizon line never leaves the ball: a sliver always shows which way is up. */
const EDGE_LIMIT = 74;

const ROLL_SCALE_INNER = 79;
const ROLL_SCALE_OUTER = 88;

/** Whether there is an attitude to draw: both values are needed. */
export function isAttitude(attitude: Attitude | null): attitude is { pitch_deg: number; roll_deg: number } {
  return attitude !== null && isDrawable(attitude.pitch_deg) && isDrawable(attitude.roll_deg);
}

/** Pitch is limited to straight up and straight down. */
export function shownPitch_deg(pitch_deg: number): number {
  return clamp(pitch_deg, -90, 90);
}

/** Turn of the outside world. SVG turns clockwise, so a right bank turns the horizon to the left. */
export function rollTurn_deg(roll_deg: number): number {
  return wrap360(round(wrap360(-roll_deg)));
}

/** Downward shift of the pitch ladder along its own turned axis: y points down, so a raised nose pushes it down. */
export function ladderShift(pitch_deg: number): number {
  return round(shownPitch_deg(pitch_deg) * UNITS_PER_DEGREE);
}

/** Downward shift of the horizon line: as the ladder, but kept within the ball. */
export function horizonShift(pitch_deg: number): number {
  return round(clamp(shownPitch_deg(pitch_deg) * UNITS_PER_DEGREE, -EDGE_LIMIT, EDGE_LIMIT));
}

/** A rung of the ladder: its height in the picture and half its width. */
export interface Rung {
  readonly pitch_deg: number;
  readonly y: number;
  readonly halfWidth: number;
}

/**
 * Widths tell the rungs apart: those of ten degrees are wide, of five middling, of two and a half short (near level
 * only).
 */
function rung(pitch_deg: number): Rung | null {
  const y = -pitch_deg * UNITS_PER_DEGREE;
  if (pitch_deg === 0) return null;
  if (pitch_deg % 10 === 0) return { pitch_deg, y, halfWidth: 24 };
  if (pitch_deg % 5 === 0) return { pitch_deg, y, halfWidth: 13 };
  return Math.abs(pitch_deg) < 20 ? { pitch_deg, y, halfWidth: 6 } : null;
}

export const RUNGS: readonly Rung[] = series(-90, 90, 2.5).flatMap((pitch_deg) => rung(pitch_deg) ?? []);

const NUMERAL_HEIGHT = 6.4;
const NUMERAL_DISTANCE = 9;

function rungPath({ pitch_deg, y, halfWidth }: Rung): string {
  const line = `M${-halfWidth} ${round(y)}H${halfWidth}`;
  if (pitch_deg % 10 !== 0) return line;
  const x = halfWidth + NUMERAL_DISTANCE;
  const tens = Math.abs(pitch_deg);
  return line + digitsPath(tens, -x, y, NUMERAL_HEIGHT) + digitsPath(tens, x, y, NUMERAL_HEIGHT);
}

/** The ladder as one path per ten degrees: few elements, and the browser skips those outside the visible part. */
export const LADDER_BANDS: readonly { readonly from_deg: number; readonly path: string }[] = series(
  -90,
  90,
  10,
).map((from_deg) => ({
  from_deg,
  path: RUNGS.filter(({ pitch_deg }) => pitch_deg >= from_deg && pitch_deg < from_deg + 10)
    .map(rungPath)
    .join(""),
}));

/** Fixed bank scale: long strokes at 30 and 60 degrees, short ones at 10, 20 and 45. */
export const ROLL_TICKS_LONG = tickPath([-60, -30, 30, 60], ROLL_SCALE_INNER, ROLL_SCALE_OUTER);
export const ROLL_TICKS_SHORT = tickPath([-45, -20, -10, 10, 20, 45], ROLL_SCALE_INNER, ROLL_SCALE_INNER + 5);
