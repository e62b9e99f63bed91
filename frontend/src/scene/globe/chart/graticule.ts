import type { Position } from "../../../lib/geodesy";
import type { Box } from "../../world/geometry";

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

const LINE = "rgb(255 255 255 / 34%)";

/** Draw the lines of a tile onto a square canvas. */
export function drawGraticule(context: CanvasRenderingContext2D, box: Box, level: number): void {
  const size_px = context.canvas.width;
  const size_deg = box.east_deg - box.west_deg;
  const step_s = graticuleStep_s(level);
  context.strokeStyle = LINE;
  context.lineWidth = 1;
  context.beginPath();
  for (const longitude of linesBetween_s(box.west_deg, box.east_deg, step_s)) {
    const x = ((longitude / 3600 - box.west_deg) / size_deg) * size_px;
    context.moveTo(x, 0);
    context.lineTo(x, size_px);
  }
  for (const latitude of linesBetween_s(box.south_deg, box.north_deg, step_s)) {
    const y = ((box.north_deg - latitude / 3600) / size_deg) * size_px;
    context.moveTo(0, y);
    context.lineTo(size_px, y);
  }
  context.stroke();
}

/** Pixels of a tile at level 0 are so large; the engine shows tiles that are up to this much too coarse. */
const LEVEL_0_M = 78_271;
const COARSE = 1.6;
/** So many lines to each side of the middle are named. */
const NAMED = 3;

interface NamedAngle {
  readonly key: string;
  readonly text: string;
  readonly place: Position;
}

/**
 * Names of lines around the middle of the picture, where a pixel is so large: meridians along the nearest parallel,
 * parallels along the nearest meridian. Only lines that are drawn on the neighbouring levels too are named: which level
 * is drawn where only the engine knows.
 */
export function nameAngles(
  { latitude_deg, longitude_deg }: Position,
  pixel_m: number,
  letters: CompassLetters,
): NamedAngle[] {
  const level = Math.max(0, Math.round(Math.log2(LEVEL_0_M / (pixel_m * COARSE))));
  const step_s = commonStep_s(
    [level - 1, level, level + 1].map((near) => graticuleStep_s(Math.max(0, near))),
  );
  const nearest = (angle_deg: number): number => Math.round((angle_deg * 3600) / step_s) * step_s;
  const [parallel_s, meridian_s] = [nearest(latitude_deg), nearest(longitude_deg)];
  const names: NamedAngle[] = [];
  for (let away = -NAMED; away <= NAMED; away += 1) {
    const latitude_s = parallel_s + away * step_s;
    const longitude_s = wrapped_s(meridian_s + away * step_s);
    if (Math.abs(latitude_s) < 90 * 3600) {
      names.push({
        key: `p${latitude_s}`,
        text: angleText(latitude_s, step_s, letters.north, letters.south),
        place: { latitude_deg: latitude_s / 3600, longitude_deg: meridian_s / 3600 },
      });
    }
    names.push({
      key: `m${longitude_s}`,
      text: angleText(longitude_s, step_s, letters.east, letters.west),
      place: { latitude_deg: parallel_s / 3600, longitude_deg: longitude_s / 3600 },
    });
  }
  return names;
}

/** The smallest of the steps that is a multiple of all of these. */
function commonStep_s(steps: readonly number[]): number {
  return STEPS_S.find((step) => steps.every((one) => step % one === 0)) ?? 324_000;
}

function wrapped_s(longitude_s: number): number {
  const whole = 360 * 3600;
  return ((((longitude_s + whole / 2) % whole) + whole) % whole) - whole / 2;
}
