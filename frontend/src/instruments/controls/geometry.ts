import { clamp, isDrawable, round } from "../dial/scale";

/**
 * The pilot's controls as the wire means them: elevator + nose up, aileron + right wing down, rudder + nose
 * right (all -1..+1), throttle 0..1. `null` is not measured.
 */
export interface Controls {
  readonly aileron: number | null;
  readonly elevator: number | null;
  readonly rudder: number | null;
  readonly throttle: number | null;
}

/** Half the side of the whole picture, in its units. */
export const PICTURE_HALF_SIDE = 84;

/** Half the side of the square in which the stick moves, in units of the picture. */
export const STICK_TRAVEL = 56;

/** Half the travel of the pedals' mark, and the whole travel of the throttle's. */
export const PEDAL_TRAVEL = 56;
export const THROTTLE_TRAVEL = 112;

/** Whether all four values are there: drawing three would invent the fourth. */
export function areControls(controls: Controls | null): controls is { [axis in keyof Controls]: number } {
  return (
    controls !== null &&
    isDrawable(controls.aileron) &&
    isDrawable(controls.elevator) &&
    isDrawable(controls.rudder) &&
    isDrawable(controls.throttle)
  );
}

/**
 * The stick seen from above: right is right, and pulling it back, which raises the nose (elevator positive),
 * moves its head down the picture, towards the pilot.
 */
export function stickShift(aileron: number, elevator: number): { x: number; y: number } {
  return { x: along(aileron, STICK_TRAVEL), y: along(elevator, STICK_TRAVEL) };
}

/** Right pedal forward turns the nose right: the mark goes right. */
export function pedalShift(rudder: number): { x: number } {
  return { x: along(rudder, PEDAL_TRAVEL) };
}

/** The lever goes up the picture as the throttle opens. */
export function throttleShift(throttle: number): { y: number } {
  return { y: round(-clamp(throttle, 0, 1) * THROTTLE_TRAVEL) };
}

function along(value: number, travel: number): number {
  return round(clamp(value, -1, 1) * travel);
}
