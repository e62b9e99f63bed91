/** Nearer than this, metres, a mark is visible even through the ground: it must never be lost. */
export const THROUGH_GROUND_M = 400_000;

const FAMILY = '"Inter Variable", system-ui, sans-serif';
export const PLAIN_FONT = `600 15px ${FAMILY}`;
export const STRONG_FONT = `700 16px ${FAMILY}`;

/** What belongs to the flight stands above all names of the ground. */
export const FLIGHT_RANK = 1000;

/** How the angle of a line of latitude or longitude is written: below all other names. */
export const GRATICULE_TEXT = {
  font: '11px "B612 Mono", "DejaVu Sans Mono", monospace',
  colour: "rgb(255 255 255 / 88%)",
  rank: 0,
  away_px: 3,
  isSought: false,
} as const;
