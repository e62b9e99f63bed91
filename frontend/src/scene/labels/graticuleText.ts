/** How the angle of a line of latitude or longitude is written: below all other names. */
export const GRATICULE_TEXT = {
  font: '11px "B612 Mono", "DejaVu Sans Mono", monospace',
  colour: "rgb(255 255 255 / 88%)",
  rank: 0,
  away_px: 3,
  isSought: false,
} as const;
