import type { PointerGeometry } from "../dial/PointerDial";
import { polar, reach, type Scale, scaleAngle_deg, series, tickPath } from "../dial/scale";

/** 0 at the top, the end of the scale just short of it again. Both demo aircraft stay well inside. */
export const AIRSPEED_SCALE: Scale = { minimum: 0, maximum: 160, start_deg: 0, sweep_deg: 330 };

const angle_deg = (airspeed_kt: number): number => scaleAngle_deg(AIRSPEED_SCALE, airspeed_kt);

const TWENTIES = series(AIRSPEED_SCALE.minimum, AIRSPEED_SCALE.maximum, 20);
const TENS = series(AIRSPEED_SCALE.minimum, AIRSPEED_SCALE.maximum, 10).filter(
  (airspeed_kt) => airspeed_kt % 20 !== 0,
);
const TWOS = series(AIRSPEED_SCALE.minimum, AIRSPEED_SCALE.maximum, 2).filter(
  (airspeed_kt) => airspeed_kt % 10 !== 0,
);

export const AIRSPEED_GEOMETRY: PointerGeometry = {
  ticksMinor: tickPath(TWOS.map(angle_deg), 83, 88),
  ticksMiddle: tickPath(TENS.map(angle_deg), 79, 88),
  ticksMajor: tickPath(TWENTIES.map(angle_deg), 76, 88),
  numerals: TWENTIES.map((airspeed_kt) => ({
    text: String(airspeed_kt),
    ...polar(62, angle_deg(airspeed_kt)),
  })),
  window: { y: 30, width: 48 },
  captionY: -28,
  pointerAngle_deg: angle_deg,
  reach: (airspeed_kt) => reach(AIRSPEED_SCALE.minimum, AIRSPEED_SCALE.maximum, airspeed_kt),
};
