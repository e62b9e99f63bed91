/** The page's unit conversions; nothing is converted elsewhere. */

export const DEGREES_PER_RADIAN = 180 / Math.PI;
/** International foot, nautical mile and knot, exact. */
export const METRES_PER_FOOT = 0.3048;
const METRES_PER_NAUTICAL_MILE = 1852;

export function degreesFromRadians(radians: number): number {
  return radians * DEGREES_PER_RADIAN;
}

export function feetFromMetres(metres: number): number {
  return metres / METRES_PER_FOOT;
}

/** The size of one unit in metres, metres a second or kelvin; `zero` is the zero of a temperature scale. */
interface Size {
  readonly size: number;
  readonly zero?: number;
}

/** The page's units, by their names in the catalogue. */
const SIZES = {
  m: { size: 1 },
  ft: { size: METRES_PER_FOOT },
  km: { size: 1000 },
  nm: { size: METRES_PER_NAUTICAL_MILE },
  mPerS: { size: 1 },
  kt: { size: METRES_PER_NAUTICAL_MILE / 3600 },
  kmPerH: { size: 1 / 3.6 },
  ftPerMin: { size: METRES_PER_FOOT / 60 },
  degC: { size: 1, zero: 273.15 },
  degF: { size: 5 / 9, zero: 273.15 - 32 * (5 / 9) },
} as const satisfies Readonly<Record<string, Size>>;

export type UnitName = keyof typeof SIZES;

/** Convert `value` between two units of the same quantity; unchanged if they are the same. */
export function convertUnit(value: number, from: UnitName, to: UnitName): number {
  if (from === to) {
    return value;
  }
  const source: Size = SIZES[from];
  const target: Size = SIZES[to];
  return (value * source.size + (source.zero ?? 0) - (target.zero ?? 0)) / target.size;
}

/** Angle in 0 <= x < 360 degrees; the board sends headings as -180..180 or 0..360. */
export function wrap360(angle_deg: number): number {
  const wrapped = angle_deg % 360;
  // The last step makes 0 of -0, and of a tiny negative number that adds up to exactly 360.
  const positive = wrapped < 0 ? wrapped + 360 : wrapped;
  return positive === 360 || positive === 0 ? 0 : positive;
}

/** The same angle in -180 <= x < 180 degrees. */
export function wrap180(angle_deg: number): number {
  return wrap360(angle_deg + 180) - 180;
}

/** The greatest of 1, 2, 5, 10, 20, 50... up to `most`, which is positive. */
export function roundLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([5, 2].find((step) => step * power <= most) ?? 1);
}
