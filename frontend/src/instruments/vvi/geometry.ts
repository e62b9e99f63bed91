import type { PointerGeometry } from "../dial/PointerDial";
import { polar, reach, type Scale, scaleAngle_deg, series, tickPath } from "../dial/scale";

/** Zero at nine o'clock, climb over the top, descent under it; the ends keep a gap between +2000 and -2000. */
export const VERTICAL_SPEED_SCALE: Scale = { minimum: -2000, maximum: 2000, start_deg: -255, sweep_deg: 330 };

const { minimum, maximum } = VERTICAL_SPEED_SCALE;

const angle_deg = (vertical_speed_ft_min: number): number =>
  scaleAngle_deg(VERTICAL_SPEED_SCALE, vertical_speed_ft_min);

const MAJOR = series(minimum, maximum, 500);
const MIDDLE = series(minimum, maximum, 100).filter((rate) => rate % 500 !== 0);
const MINOR = series(-950, 950, 50).filter((rate) => rate % 100 !== 0);

export const VERTICAL_SPEED_GEOMETRY: PointerGeometry = {
  ticksMinor: tickPath(MINOR.map(angle_deg), 83, 88),
  ticksMiddle: tickPath(MIDDLE.map(angle_deg), 80, 88),
  ticksMajor: tickPath(MAJOR.map(angle_deg), 76, 88),
  numerals: MAJOR.map((rate) => ({ text: String(Math.abs(rate) / 100), ...polar(63, angle_deg(rate)) })),
  // Arrows above and under the zero: which half of the dial is climb, and which descent.
  signs: "M-60 -24L-55.5 -16H-64.5ZM-60 24L-55.5 16H-64.5Z",
  window: { y: 28, width: 68 },
  captionY: -28,
  pointerAngle_deg: angle_deg,
  reach: (vertical_speed_ft_min) => reach(minimum, maximum, vertical_speed_ft_min),
};
