import type { PointerGeometry } from "../dial/PointerDial";
import { clamp, polar, reach, series, tickPath } from "../dial/scale";

/** What the number's window can hold; beyond it the pointer stops and the instrument says so. */
export const ALTITUDE_MINIMUM_FT = -2000;
export const ALTITUDE_MAXIMUM_FT = 99_999;

const FEET_PER_TURN = 1000;

/**
 * One turn of the pointer for a thousand feet; the thousands stand in the window. The angle grows without a
 * wrap, so that it is the value, and never the drawing, which decides where the pointer is.
 */
export function altitudeAngle_deg(altitude_ft: number): number {
  return (clamp(altitude_ft, ALTITUDE_MINIMUM_FT, ALTITUDE_MAXIMUM_FT) / FEET_PER_TURN) * 360;
}

const HUNDREDS = series(0, 900, 100);
const FIFTIES = series(50, 950, 100);
const TWENTIES = series(0, 980, 20).filter((altitude_ft) => altitude_ft % 100 !== 0);

export const ALTITUDE_GEOMETRY: PointerGeometry = {
  ticksMinor: tickPath(TWENTIES.map(altitudeAngle_deg), 82, 88),
  ticksMiddle: tickPath(FIFTIES.map(altitudeAngle_deg), 80, 88),
  ticksMajor: tickPath(HUNDREDS.map(altitudeAngle_deg), 76, 88),
  numerals: HUNDREDS.map((altitude_ft) => ({
    text: String(altitude_ft / 100),
    ...polar(64, altitudeAngle_deg(altitude_ft)),
  })),
  window: { y: 28, width: 68 },
  captionY: -28,
  pointerAngle_deg: altitudeAngle_deg,
  reach: (altitude_ft) => reach(ALTITUDE_MINIMUM_FT, ALTITUDE_MAXIMUM_FT, altitude_ft),
};
