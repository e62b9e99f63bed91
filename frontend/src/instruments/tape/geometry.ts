import { convertUnit, type UnitName } from "../../lib/units";
import { clamp, isDrawable, round } from "../dial/scale";

/** A scale that slides behind its index: how much of it is seen, and how it is divided, in the unit on its face. */
export interface TapeScale {
  readonly unit: UnitName;
  /** From the lower edge to the upper. */
  readonly seen: number;
  /** Between two numbers, and between two strokes. */
  readonly major: number;
  readonly minor: number;
  /** Below it the scale has no numbers: there is no such value. */
  readonly least: number;
}

/** The first is the usual one. */
type Tapes = readonly [TapeScale, ...TapeScale[]];

export const SPEED_TAPES: Tapes = [
  { unit: "kt", seen: 60, major: 10, minor: 5, least: 0 },
  { unit: "kmPerH", seen: 120, major: 20, minor: 10, least: 0 },
  { unit: "mPerS", seen: 30, major: 5, minor: 1, least: 0 },
];

export const ALTITUDE_TAPES: Tapes = [
  { unit: "ft", seen: 400, major: 100, minor: 20, least: Number.NEGATIVE_INFINITY },
  { unit: "m", seen: 120, major: 20, minor: 10, least: Number.NEGATIVE_INFINITY },
];

/** The tape of the user's unit; the usual one if there is none for it. */
export function tapeOf(tapes: Tapes, unit: UnitName): TapeScale {
  return tapes.find((tape) => tape.unit === unit) ?? tapes[0];
}

/** Strokes and numbers drawn on each side of the middle one: enough for half of what is seen and one number more. */
export function marksBeside({ seen, major }: TapeScale): number {
  return Math.ceil(seen / 2 / major) + 1;
}

/** The number that stands nearest to a value: the drawn piece of the scale is centred on it. */
export function middleOf({ major }: TapeScale, shown: number): number {
  return Math.round(shown / major) * major;
}

/** The numbers of the drawn piece from the top down; none below the scale's least. */
export function numbersOf(scale: TapeScale, middle: number): string[] {
  const beside = marksBeside(scale);
  return Array.from({ length: 2 * beside + 1 }, (_, row) => {
    const number = middle + (beside - row) * scale.major;
    return number < scale.least ? "" : String(number);
  });
}

/** How far the drawn piece is shifted down, in percent of the tape's height: a greater value brings the upper part down. */
export function shiftPercent({ seen }: TapeScale, shown: number, middle: number): number {
  return round(((shown - middle) / seen) * 100);
}

/** Where a bug stands, in percent of the height from the middle, down positive; it never leaves the tape. */
export function bugPercent({ seen }: TapeScale, shown: number, bug: number): number {
  return round(clamp(((shown - bug) / seen) * 100, -47, 47));
}

/** A value in its usual unit (knots, feet) on this tape; null if there is nothing to draw. */
export function onTape({ unit }: TapeScale, value: number | null, usual: UnitName): number | null {
  return isDrawable(value) ? convertUnit(value, usual, unit) : null;
}
