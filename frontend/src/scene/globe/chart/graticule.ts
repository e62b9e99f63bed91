import type { Box } from "./geometry";

/** Possible distances between the lines, in seconds of arc: round for people. */
const STEPS_S = [
  1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 18_000, 36_000, 54_000, 108_000,
];
/** About this many lines cross a tile. */
const LINES_PER_TILE = 1.6;

/** Letters of the cardinal points in the page's language. */
export interface CompassLetters {
  readonly north: string;
  readonly south: string;
  readonly east: string;
  readonly west: string;
}

/** Distance between the lines on a level, in seconds of arc. */
export function graticuleStep_s(level: number): number {
  const wanted_s = (180 * 3600) / 2 ** level / LINES_PER_TILE;
  return STEPS_S.find((step) => step >= wanted_s) ?? 216_000;
}

/** The lines from one angle to another, both in degrees: whole multiples of the step, in seconds of arc. */
export function linesBetween_s(from_deg: number, to_deg: number, step_s: number): number[] {
  const first = Math.ceil((from_deg * 3600 - 1e-6) / step_s);
  const last = Math.floor((to_deg * 3600 + 1e-6) / step_s);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, index) => (first + index) * step_s);
}

/** "27°55′N": as short as the step allows. */
export function angleText(angle_s: number, step_s: number, positive: string, negative: string): string {
  const whole = Math.abs(Math.round(angle_s));
  const minutes = Math.floor(whole / 60) % 60;
  const two = (number: number): string => String(number).padStart(2, "0");
  const text =
    `${Math.floor(whole / 3600)}°` +
    (step_s < 3600 ? `${two(minutes)}′` : "") +
    (step_s < 60 ? `${two(whole % 60)}″` : "");
  return whole === 0 ? text : text + (angle_s > 0 ? positive : negative);
}

/** Room for the label of a neighbouring tile, as a share of the tile. */
const REACH = 0.4;
const LINE = "rgb(255 255 255 / 34%)";
const INK = "rgb(255 255 255 / 88%)";
const EDGE = "rgb(8 20 30 / 75%)";

/** Draw the lines of a tile, and at each crossing the two angles, onto a square canvas. */
export function drawGraticule(
  context: CanvasRenderingContext2D,
  box: Box,
  level: number,
  letters: CompassLetters,
): void {
  const size_px = context.canvas.width;
  const size_deg = box.east_deg - box.west_deg;
  const step_s = graticuleStep_s(level);
  const reach_deg = REACH * size_deg;
  const x = (longitude_s: number): number => ((longitude_s / 3600 - box.west_deg) / size_deg) * size_px;
  const y = (latitude_s: number): number => ((box.north_deg - latitude_s / 3600) / size_deg) * size_px;
  const meridians = linesBetween_s(
    Math.max(-180, box.west_deg - reach_deg),
    Math.min(180, box.east_deg + reach_deg),
    step_s,
  );
  const parallels = linesBetween_s(
    Math.max(-90, box.south_deg - reach_deg),
    Math.min(90, box.north_deg + reach_deg),
    step_s,
  );
  context.strokeStyle = LINE;
  context.lineWidth = 1;
  context.beginPath();
  for (const longitude of meridians) {
    context.moveTo(x(longitude), 0);
    context.lineTo(x(longitude), size_px);
  }
  for (const latitude of parallels) {
    context.moveTo(0, y(latitude));
    context.lineTo(size_px, y(latitude));
  }
  context.stroke();
  context.font = `${size_px / 22}px "B612 Mono", "DejaVu Sans Mono", monospace`;
  context.fillStyle = INK;
  context.strokeStyle = EDGE;
  context.lineWidth = size_px / 90;
  context.lineJoin = "round";
  const write = (text: string, at_x: number, at_y: number): void => {
    context.strokeText(text, at_x, at_y);
    context.fillText(text, at_x, at_y);
  };
  const gap = size_px / 70;
  for (const longitude of meridians) {
    for (const latitude of parallels) {
      write(angleText(latitude, step_s, letters.north, letters.south), x(longitude) + gap, y(latitude) - gap);
      context.save();
      context.translate(x(longitude) - gap, y(latitude) - gap);
      context.rotate(-Math.PI / 2);
      write(angleText(longitude, step_s, letters.east, letters.west), 0, 0);
      context.restore();
    }
  }
}
