/** Unit conversions of the page; nothing converts inline. */

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

/** One of a unit in metres, metres a second or kelvin; the zero of a temperature scale lies at `zero`. */
interface Size {
  readonly size: number;
  readonly zero?: number;
}

/** The units between which the page converts, by the names which they have in the catalogue. */
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

/** `value` from one unit into another of the same quantity; a value already in its unit comes back untouched. */
export function convertUnit(value: number, from: UnitName, to: UnitName): number {
  if (from === to) {
    return value;
  }
  const source: Size = SIZES[from];
  const target: Size = SIZES[to];
  return (value * source.size + (source.zero ?? 0) - (target.zero ?? 0)) / target.size;
}
