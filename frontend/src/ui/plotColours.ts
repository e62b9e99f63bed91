/**
 * Number of lines that can be told apart by colour; each also has its own dashes, for people who do not see colours.
 */
export const PLOT_COLOURS = 6;

export const PLOT_DASHES: ReadonlyArray<readonly number[]> = [
  [],
  [8, 4],
  [2, 3],
  [12, 3, 2, 3],
  [5, 2],
  [1, 5],
];

/** Custom property with the colour of a line. */
export function plotColour(index: number): `--plot-${number}` {
  return `--plot-${(index % PLOT_COLOURS) + 1}`;
}
