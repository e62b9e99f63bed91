/** The positions of the two switches and the autopilot; `null` if unknown. */
export interface Switches {
  readonly source: "joystick" | "rc" | null;
  /** Manual: straight to the simulator's surfaces. Assisted: through the on-board computer. */
  readonly path: "manual" | "assisted" | null;
  /** The autopilot of the chosen source. */
  readonly autopilot: boolean | null;
}

/** The parts of the picture that carry the control signal now. */
export interface SignalWay {
  readonly joystick: boolean;
  readonly rc: boolean;
  /** From the first switch to the second. */
  readonly between: boolean;
  readonly manual: boolean;
  /** From the second switch into the computer. */
  readonly assisted: boolean;
  /** From the computer to the surfaces. */
  readonly computer: boolean;
  /** From the autopilot into the computer; stick and transmitter then move nothing. */
  readonly automatic: boolean;
}

/** Follows the signal back from the surfaces, as far as it is known. */
export function signalWay({ source, path, autopilot }: Switches): SignalWay {
  const manual = path === "manual";
  const computer = path === "assisted";
  // If the autopilot's state is unknown, so is whether the pilot's signal counts.
  const assisted = computer && autopilot === false;
  const piloted = manual || assisted;
  return {
    manual,
    computer,
    automatic: computer && autopilot === true,
    assisted,
    joystick: piloted && source === "joystick",
    rc: piloted && source === "rc",
    between: piloted && source !== null,
  };
}

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** A two-position switch: the blade turns about its pole and meets one of two contacts, one above the other. */
export interface SwitchPlace {
  readonly pole: Point;
  readonly contactX: number;
}

export const UPPER_Y = 34;
export const LOWER_Y = 98;
const POLE_Y = (UPPER_Y + LOWER_Y) / 2;

export const SOURCE_SWITCH: SwitchPlace = { pole: { x: 112, y: POLE_Y }, contactX: 88 };
export const PATH_SWITCH: SwitchPlace = { pole: { x: 134, y: POLE_Y }, contactX: 158 };

export type BladePosition = "upper" | "lower" | null;

/** End of the blade: on a contact, or between the two if the position is unknown. */
export function bladeEnd({ pole, contactX }: SwitchPlace, position: BladePosition): Point {
  if (position === null) {
    return { x: pole.x + (contactX - pole.x) * 0.75, y: pole.y };
  }
  return { x: contactX, y: position === "upper" ? UPPER_Y : LOWER_Y };
}

/** Direction from one point to another, degrees clockwise from the x axis: the turn of an arrow's head. */
export function direction_deg(from: Point, to: Point): number {
  return (Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI;
}
