/** Angle in 0 <= x < 360 degrees; the board sends headings as -180..180 or 0..360. */
export function wrap360(angle_deg: number): number {
  const wrapped = angle_deg % 360;
  // The last step makes 0 of -0, and of a tiny negative number that adds up to exactly 360.
  const positive = wrapped < 0 ? wrapped + 360 : wrapped;
  return positive === 360 || positive === 0 ? 0 : positive;
}

/** The same angle in -180 <= x < 180 degrees. */
export function wrap180(angle_deg: number): number {
  return wrap360(angle_deg + 180) - 180;
}
