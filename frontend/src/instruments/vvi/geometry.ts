import { convertUnit } from "../../lib/units";
import type { PointerGeometry } from "../dial/PointerDial";
import { polar, reach, type Scale, scaleAngle_deg, series, tickPath } from "../dial/scale";

/** Units in which a vertical speed indicator is engraved. */
export type VerticalSpeedUnit = "ftPerMin" | "mPerS";

/** The scale: its end in both directions, the steps of its marks, and the unit of a numeral. */
interface ScaleMarks {
  readonly end: number;
  readonly major: number;
  readonly middle: number;
  readonly minor: number;
  readonly numeral: number;
}

/**
 * Zero at nine o'clock, climb over the top, descent below; a gap remains between the ends. It is painted in feet per
 * minute, whatever unit is on its face.
 */
function face(unit: VerticalSpeedUnit, { end, major, middle, minor, numeral }: ScaleMarks): PointerGeometry {
  const scale: Scale = { minimum: -end, maximum: end, start_deg: -255, sweep_deg: 330 };
  const angle_deg = (engraved: number): number => scaleAngle_deg(scale, engraved);
  const shown = (vertical_speed_ft_min: number): number =>
    convertUnit(vertical_speed_ft_min, "ftPerMin", unit);
  return {
    ticksMinor: tickPath(series(-end, end, minor).map(angle_deg), 83, 88),
    ticksMiddle: tickPath(series(-end, end, middle).map(angle_deg), 80, 88),
    ticksMajor: tickPath(series(-end, end, major).map(angle_deg), 76, 88),
    numerals: series(-end, end, major).map((engraved) => ({
      text: String(Math.abs(engraved) / numeral),
      ...polar(63, angle_deg(engraved)),
    })),
    // Arrows above and below the zero: which half is climb and which descent.
    signs: "M-60 -24L-55.5 -16H-64.5ZM-60 24L-55.5 16H-64.5Z",
    window: { y: 28, width: 68 },
    captionY: -28,
    pointerAngle_deg: (vertical_speed_ft_min) => angle_deg(shown(vertical_speed_ft_min)),
    reach: (vertical_speed_ft_min) => reach(-end, end, shown(vertical_speed_ft_min)),
  };
}

export const VERTICAL_SPEED_GEOMETRY: Readonly<Record<VerticalSpeedUnit, PointerGeometry>> = {
  ftPerMin: face("ftPerMin", { end: 2000, major: 500, middle: 100, minor: 50, numeral: 100 }),
  mPerS: face("mPerS", { end: 10, major: 2, middle: 1, minor: 0.5, numeral: 1 }),
};
