/** Unit conversions of the page; nothing converts inline. */

export const DEGREES_PER_RADIAN = 180 / Math.PI;
/** International foot, exact. */
export const METRES_PER_FOOT = 0.3048;

export function degreesFromRadians(radians: number): number {
  return radians * DEGREES_PER_RADIAN;
}

export function feetFromMetres(metres: number): number {
  return metres / METRES_PER_FOOT;
}
