import { convertUnit } from "../../lib/units";
import type { PointerGeometry } from "../dial/PointerDial";
import { polar, reach, type Scale, scaleAngle_deg, series, tickPath } from "../dial/scale";

/** Units in which an airspeed indicator is engraved. */
export type AirspeedUnit = "kt" | "kmPerH" | "mPerS";

/** A pitot tube at rest reports a little under zero: noise, not a speed off the scale. */
const REST_NOISE_KT = 2;

/**
 * A face from 0 at the top to its end just before the top again; both demo aircraft stay well inside. It is painted
 * in knots, whatever unit is on its face.
 */
function face(
  unit: AirspeedUnit,
  maximum: number,
  [major, middle, minor]: readonly number[],
): PointerGeometry {
  const scale: Scale = { minimum: 0, maximum, start_deg: 0, sweep_deg: 330 };
  const angle_deg = (engraved: number): number => scaleAngle_deg(scale, engraved);
  const shown = (airspeed_kt: number): number => convertUnit(airspeed_kt, "kt", unit);
  const marks = (step = maximum): number[] => series(0, maximum, step);
  return {
    ticksMinor: tickPath(marks(minor).map(angle_deg), 83, 88),
    ticksMiddle: tickPath(marks(middle).map(angle_deg), 79, 88),
    ticksMajor: tickPath(marks(major).map(angle_deg), 76, 88),
    numerals: marks(major).map((engraved) => ({ text: String(engraved), ...polar(62, angle_deg(engraved)) })),
    window: { y: 30, width: 48 },
    captionY: -28,
    pointerAngle_deg: (airspeed_kt) => angle_deg(shown(airspeed_kt)),
    reach: (airspeed_kt) =>
      airspeed_kt < 0 && airspeed_kt >= -REST_NOISE_KT ? "within" : reach(0, maximum, shown(airspeed_kt)),
  };
}

export const AIRSPEED_GEOMETRY: Readonly<Record<AirspeedUnit, PointerGeometry>> = {
  kt: face("kt", 160, [20, 10, 2]),
  kmPerH: face("kmPerH", 300, [50, 10, 5]),
  mPerS: face("mPerS", 80, [10, 5, 1]),
};
