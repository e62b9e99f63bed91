import { writeEcef } from "../ecef";
import { BLOCK_POINTS, DEGREES_PER_UNIT, METRES_PER_UNIT, type TrackBlock } from "./block";

/** An error of 1 m/s in the colour counts as this many metres of position error, from 0.5 m/s on. */
const METRES_PER_MPS = 20;
const UNSEEN_MPS = 0.5;

/** A complete block with the weight of each of its points, from which every level of detail follows. */
export interface WeightedBlock {
  readonly block: TrackBlock;
  /**
   * `keep_m[i]`: point i is needed if the line may deviate less than this from the flown one. The points with `keep_m
   * > e` form a line that deviates at most `e` metres (Douglas and Peucker). Both ends and the ends of pieces are in
   * every line, so that neighbours meet at any mix of levels.
   */
  readonly keep_m: Float32Array;
  /** A sphere, earth-centred metres, that holds all points. */
  readonly centre: readonly [number, number, number];
  readonly radius_m: number;
  /** A sphere for each `PIECE_POINTS` points: x, y, z and radius in a row, accurate to a metre. */
  readonly pieces_m: Float32Array;
}

export const PIECE_POINTS = 64;
/** More than the rounding of a position to float32. */
const COARSE_M = 1;
const places = new Float64Array(3 * BLOCK_POINTS);

/** Takes some tenths of a millisecond: 1,024 points in about ten rounds. */
export function thin(block: TrackBlock): WeightedBlock {
  writePlaces(block);
  const keep_m = new Float32Array(block.count);
  const bounds = [0, ...block.starts.filter((start) => start > 0), block.count];
  for (let piece = 0; piece + 1 < bounds.length; piece += 1) {
    const first = bounds[piece] ?? 0;
    const last = (bounds[piece + 1] ?? 0) - 1;
    keep_m[first] = Number.POSITIVE_INFINITY;
    keep_m[last] = Number.POSITIVE_INFINITY;
    weigh(block, keep_m, first, last);
  }
  return { block, keep_m, ...ball(0, block.count), pieces_m: pieces(block.count) };
}

function pieces(count: number): Float32Array {
  const found = new Float32Array(4 * Math.ceil(count / PIECE_POINTS));
  for (let piece = 0; piece * PIECE_POINTS < count; piece += 1) {
    const { centre, radius_m } = ball(piece * PIECE_POINTS, Math.min(count, (piece + 1) * PIECE_POINTS));
    found.set([...centre, radius_m + COARSE_M], 4 * piece);
  }
  return found;
}

/** Offsets of the points of a line within `tolerance_m` of the flown one. */
export function kept({ keep_m }: WeightedBlock, tolerance_m: number): number[] {
  const offsets: number[] = [];
  for (let offset = 0; offset < keep_m.length; offset += 1) {
    if ((keep_m[offset] ?? 0) > tolerance_m) {
      offsets.push(offset);
    }
  }
  return offsets;
}

/** Splits recursively at the farthest point; no point weighs more than the one whose split made its part. */
function weigh(block: TrackBlock, keep_m: Float32Array, begin: number, end: number): void {
  const waiting = [begin, end, Number.POSITIVE_INFINITY];
  while (waiting.length > 0) {
    const limit_m = waiting.pop() ?? 0;
    const last = waiting.pop() ?? 0;
    const first = waiting.pop() ?? 0;
    let farthest = -1;
    let most_m = -1;
    for (let offset = first + 1; offset < last; offset += 1) {
      const stray = stray_m(block, first, last, offset);
      if (stray > most_m) {
        most_m = stray;
        farthest = offset;
      }
    }
    if (farthest >= 0) {
      const weight_m = Math.min(most_m, limit_m);
      keep_m[farthest] = weight_m;
      waiting.push(first, farthest, weight_m, farthest, last, weight_m);
    }
  }
}

/** Deviation of a point from the straight line between two others, in position or in the coloured values. */
function stray_m(block: TrackBlock, first: number, last: number, offset: number): number {
  const [from, to, at] = [3 * first, 3 * last, 3 * offset];
  const x = places[from] ?? 0;
  const y = places[from + 1] ?? 0;
  const z = places[from + 2] ?? 0;
  const dx = (places[to] ?? 0) - x;
  const dy = (places[to + 1] ?? 0) - y;
  const dz = (places[to + 2] ?? 0) - z;
  const px = (places[at] ?? 0) - x;
  const py = (places[at + 1] ?? 0) - y;
  const pz = (places[at + 2] ?? 0) - z;
  const length2 = dx * dx + dy * dy + dz * dz;
  const along = length2 === 0 ? 0 : Math.max(0, Math.min(1, (px * dx + py * dy + pz * dz) / length2));
  const rx = px - along * dx;
  const ry = py - along * dy;
  const rz = pz - along * dz;
  return Math.max(
    Math.sqrt(rx * rx + ry * ry + rz * rz),
    colour_m(block.speed_mps, first, last, offset, along),
    colour_m(block.climb_mps, first, last, offset, along),
  );
}

function colour_m(values: Float32Array, first: number, last: number, offset: number, along: number): number {
  const from = known(values[first]);
  const wrong = Math.abs(known(values[offset]) - from - along * (known(values[last]) - from));
  return wrong > UNSEEN_MPS ? METRES_PER_MPS * (wrong - UNSEEN_MPS) : 0;
}

/** Unknown counts as zero: the line's colour changes where the value becomes known. */
function known(value: number | undefined): number {
  return value === undefined || Number.isNaN(value) ? 0 : value;
}

function writePlaces({ count, latitude_e7, longitude_e7, altitude_mm }: TrackBlock): void {
  for (let offset = 0; offset < count; offset += 1) {
    writeEcef(
      places,
      3 * offset,
      (latitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
      (longitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
      (altitude_mm[offset] ?? 0) * METRES_PER_UNIT,
    );
  }
}

/** A sphere that holds the points from the first index up to the second. */
function ball(first: number, end: number): Pick<WeightedBlock, "centre" | "radius_m"> {
  const least = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const most = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let index = 3 * first; index < 3 * end; index += 1) {
    const axis = index % 3;
    const value = places[index] ?? 0;
    least[axis] = Math.min(least[axis] ?? value, value);
    most[axis] = Math.max(most[axis] ?? value, value);
  }
  const middle = (axis: number): number => ((least[axis] ?? 0) + (most[axis] ?? 0)) / 2;
  const half = (axis: number): number => ((most[axis] ?? 0) - (least[axis] ?? 0)) / 2;
  return {
    centre: [middle(0), middle(1), middle(2)],
    radius_m: Math.hypot(half(0), half(1), half(2)),
  };
}
