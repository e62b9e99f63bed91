import { convertUnit } from "../../lib/units";
import type { PointerGeometry } from "../dial/PointerDial";
import { clamp, polar, reach, series, tickPath } from "../dial/scale";

/** Units in which an altimeter is engraved. */
export type AltitudeUnit = "ft" | "m";

/** Range of the number; beyond it the pointer stops and the instrument says so. */
export const ALTITUDE_MINIMUM_FT = -2000;
export const ALTITUDE_MAXIMUM_FT = 99_999;

const PER_TURN = 1000;

/**
 * One turn of the pointer for a thousand feet, or metres; the number shows the thousands. The angle is not wrapped,
 * so the pointer's way follows from the value alone.
 */
function face(unit: AltitudeUnit): PointerGeometry {
  const engraved_deg = (altitude: number): number => (altitude / PER_TURN) * 360;
  const hundreds = series(0, 900, 100);
  const fifties = series(50, 950, 100);
  const twenties = series(0, 980, 20).filter((altitude) => altitude % 100 !== 0);
  return {
    ticksMinor: tickPath(twenties.map(engraved_deg), 82, 88),
    ticksMiddle: tickPath(fifties.map(engraved_deg), 80, 88),
    ticksMajor: tickPath(hundreds.map(engraved_deg), 76, 88),
    numerals: hundreds.map((altitude) => ({
      text: String(altitude / 100),
      ...polar(64, engraved_deg(altitude)),
    })),
    window: { y: 28, width: 68 },
    captionY: -28,
    pointerAngle_deg: (altitude_ft) =>
      engraved_deg(convertUnit(clamp(altitude_ft, ALTITUDE_MINIMUM_FT, ALTITUDE_MAXIMUM_FT), "ft", unit)),
    reach: (altitude_ft) => reach(ALTITUDE_MINIMUM_FT, ALTITUDE_MAXIMUM_FT, altitude_ft),
  };
}

export const ALTITUDE_GEOMETRY: Readonly<Record<AltitudeUnit, PointerGeometry>> = {
  ft: face("ft"),
  m: face("m"),
};
