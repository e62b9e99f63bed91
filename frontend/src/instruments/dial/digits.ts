import { round } from "./scale";

/**
 * Digits drawn as strokes. Text in a group that turns is laid out again in each animation frame, which cost a third
 * of the attitude indicator's time; a path is only drawn. Cells of 4 by 6, y down, in M, L and Q commands with one "x
 * y" pair per point.
 */
const STROKES: Readonly<Record<string, string>> = {
  "0": "M2 0Q4 0 4 3Q4 6 2 6Q0 6 0 3Q0 0 2 0",
  "1": "M0.7 1.3L2.4 0L2.4 6",
  "2": "M0.1 1.3Q0.4 0 2 0Q3.9 0 3.9 1.7Q3.9 2.8 0 6L4 6",
  "3": "M0.3 0.9Q0.8 0 2 0Q3.7 0 3.7 1.4Q3.7 2.8 1.5 2.8Q4 2.8 4 4.4Q4 6 2 6Q0.5 6 0 4.9",
  "4": "M3 6L3 0L0 4.3L4 4.3",
  "5": "M3.7 0L0.6 0L0.3 2.8Q1 2.3 2 2.3Q4 2.3 4 4.1Q4 6 2 6Q0.5 6 0 5",
  "6": "M3.5 0.7Q3 0 2.2 0Q0 0 0 3.6Q0 6 2 6Q4 6 4 4.1Q4 2.4 2.1 2.4Q0.4 2.4 0 3.9",
  "7": "M0 0L4 0L1.4 6",
  "8": "M2 2.8Q0.3 2.8 0.3 1.4Q0.3 0 2 0Q3.7 0 3.7 1.4Q3.7 2.8 2 2.8Q0 2.8 0 4.4Q0 6 2 6Q4 6 4 4.4Q4 2.8 2 2.8",
  "9": "M0.5 5.3Q1 6 1.8 6Q4 6 4 2.4Q4 0 2 0Q0 0 0 1.9Q0 3.6 1.9 3.6Q3.6 3.6 4 2.1",
};

const CELL_WIDTH = 4;
const CELL_HEIGHT = 6;
const CELL_GAP = 1.8;

/** SVG path of a whole number without sign, `height` units high, its middle at (`x`, `y`). */
export function digitsPath(value: number, x: number, y: number, height: number): string {
  const digits = [...String(value)];
  const scale = height / CELL_HEIGHT;
  const width = (digits.length * (CELL_WIDTH + CELL_GAP) - CELL_GAP) * scale;
  return digits
    .map((digit, index) => {
      const left = x - width / 2 + index * (CELL_WIDTH + CELL_GAP) * scale;
      const top = y - height / 2;
      return (STROKES[digit] ?? "").replaceAll(
        /(?<cellX>[\d.]+) (?<cellY>[\d.]+)/g,
        (_, cellX: string, cellY: string) =>
          `${round(left + Number(cellX) * scale)} ${round(top + Number(cellY) * scale)}`,
      );
    })
    .join("");
}
