import type { TrackPoints, ValueRange } from "./trackPoints";

/** The value that colours a track. */
export const COLOURINGS = ["none", "height", "speed", "climb"] as const;
export type Colouring = (typeof COLOURINGS)[number];

export type Rgb = readonly [red: number, green: number, blue: number];

/** The colour of an unknown value. */
export const UNKNOWN_COLOUR = "#9a9a9a";

/**
 * From least to most, in equal steps. Both scales can be read with any kind of colour blindness, because lightness
 * alone gives the value: cividis (Nuñez, Anderton and Renslow 2018) without its darkest end for values with a
 * minimum, and blue through white to orange for values around zero.
 */
export const SCALES: Readonly<Record<Exclude<Colouring, "none">, readonly string[]>> = {
  height: ["#1f3c6e", "#4b546c", "#6c6d72", "#8c8676", "#aea371", "#d3c164", "#fee838"],
  speed: ["#1f3c6e", "#4b546c", "#6c6d72", "#8c8676", "#aea371", "#d3c164", "#fee838"],
  climb: ["#0571b0", "#5aa5d0", "#b5d5e8", "#f7f7f7", "#fbcf9d", "#ef9a4c", "#c95a00"],
};

/** The values at the scale's ends. */
export interface Range {
  readonly least: number;
  readonly most: number;
}

/** Red, green and blue from 0 to 1 of "#rrggbb". */
export function rgb(colour: string): Rgb {
  const part = (at: number): number => Number.parseInt(colour.slice(at, at + 2), 16) / 255;
  return [part(1), part(3), part(5)];
}

/** The colour of a value; null is unknown. A value outside the range has the colour of its end. */
export function colourOf(scale: readonly string[], { least, most }: Range, value: number | null): string {
  if (value === null || Number.isNaN(value)) {
    return UNKNOWN_COLOUR;
  }
  const place = Math.max(0, Math.min(1, (value - least) / (most - least))) * (scale.length - 1);
  const from = rgb(scale[Math.floor(place)] ?? UNKNOWN_COLOUR);
  const to = rgb(scale[Math.ceil(place)] ?? UNKNOWN_COLOUR);
  const share = place - Math.floor(place);
  const part = (at: number): string =>
    Math.round(255 * ((from[at] ?? 0) + share * ((to[at] ?? 0) - (from[at] ?? 0))))
      .toString(16)
      .padStart(2, "0");
  return `#${part(0)}${part(1)}${part(2)}`;
}

/**
 * The range of the scale for some tracks, in the shown unit: round numbers that include all values. Height and speed
 * begin at 0 or below, climb has 0 in the middle. Null while unknown.
 */
export function rangeOf(
  colouring: Exclude<Colouring, "none">,
  tracks: readonly TrackPoints[],
  convert: (si: number) => number,
): Range | null {
  const spreads = tracks.flatMap((points) => spreadOf(colouring, points) ?? []);
  if (spreads.length === 0) {
    return null;
  }
  const least = convert(Math.min(...spreads.map((spread) => spread.least)));
  const most = convert(Math.max(...spreads.map((spread) => spread.most)));
  if (colouring === "climb") {
    const end = roundUp(Math.max(Math.abs(least), Math.abs(most)));
    return { least: -end, most: end };
  }
  return { least: least < 0 ? -roundUp(-least) : 0, most: roundUp(most) };
}

function spreadOf(colouring: Exclude<Colouring, "none">, points: TrackPoints): ValueRange | null {
  return { height: points.altitude_m, speed: points.speed_mps, climb: points.climb_mps }[colouring];
}

/** The next greater of 1, 2, 3, 4, 5, 6, 8 and their decades; 1 for zero. */
function roundUp(value: number): number {
  if (value <= 1) {
    return 1;
  }
  const ten = 10 ** Math.floor(Math.log10(value));
  return ([1, 2, 3, 4, 5, 6, 8].find((step) => step * ten >= value - 1e-9) ?? 10) * ten;
}
