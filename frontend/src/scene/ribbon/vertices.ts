import { writeEcef } from "../../lib/ecef";

/**
 * One point on the graphics processor, ten numbers: its earth-centred position in two parts, coarse (followed by the
 * height) and fine (followed by 1 where a piece begins), then speed and climb.
 */
export const POINT_FLOATS = 10;
export const POINT_BYTES = POINT_FLOATS * 4;
const [HEIGHT, BEGINS, SPEED, CLIMB] = [3, 7, 8, 9];
/** Marks an unknown speed or climb. */
const UNKNOWN = -1e9;

/**
 * A float32 has seven digits: relative to multiples of this many metres, a position is exact to less than a
 * centimetre.
 */
const COARSE_M = 65_536;

/** A position in the air, height above mean sea level. */
export interface Place {
  readonly latitude_deg: number;
  readonly longitude_deg: number;
  readonly altitude_m: number;
}

const place = new Float64Array(3);

/** A position that continues the line, with the speed and climb of the point before. */
export function writePlace(
  into: Float32Array,
  at: number,
  { latitude_deg, longitude_deg, altitude_m }: Place,
) {
  writeEcef(place, 0, latitude_deg, longitude_deg, altitude_m);
  const begin = at * POINT_FLOATS;
  for (let axis = 0; axis < 3; axis += 1) {
    const metres = place[axis] ?? 0;
    const coarse = Math.floor(metres / COARSE_M) * COARSE_M;
    into[begin + axis] = coarse;
    into[begin + 4 + axis] = metres - coarse;
  }
  into[begin + HEIGHT] = altitude_m;
  into[begin + BEGINS] = 0;
  for (const rate of [SPEED, CLIMB]) {
    into[begin + rate] = at === 0 ? UNKNOWN : (into[begin + rate - POINT_FLOATS] ?? UNKNOWN);
  }
}

/** Speed and climb, metres a second, of a written point; undefined or NaN: unknown. */
export function writeRates(
  into: Float32Array,
  at: number,
  speed_mps: number | undefined,
  climb_mps: number | undefined,
): void {
  into[at * POINT_FLOATS + SPEED] = known(speed_mps);
  into[at * POINT_FLOATS + CLIMB] = known(climb_mps);
}

/** Begin a piece: nothing is drawn from the point before. */
export function beginPiece(into: Float32Array, at: number): void {
  into[at * POINT_FLOATS + BEGINS] = 1;
}

/** Position of a written point, earth-centred metres. */
export function placeOf(vertices: Float32Array, at: number): [number, number, number] {
  const part = (axis: number): number =>
    (vertices[at * POINT_FLOATS + axis] ?? 0) + (vertices[at * POINT_FLOATS + 4 + axis] ?? 0);
  return [part(0), part(1), part(2)];
}

/** A sphere around points, earth-centred metres, and their greatest height. */
export interface Bounds {
  readonly centre: readonly [number, number, number];
  readonly radius_m: number;
  readonly top_m: number;
}

/** Bounds of the first `count` points; computed for each picture, so nothing is allocated per point. */
export function boundsOf(vertices: Float32Array, count: number): Bounds {
  least.fill(Number.POSITIVE_INFINITY);
  most.fill(Number.NEGATIVE_INFINITY);
  let top_m = Number.NEGATIVE_INFINITY;
  for (let begin = 0; begin < count * POINT_FLOATS; begin += POINT_FLOATS) {
    for (let axis = 0; axis < 3; axis += 1) {
      const metres = (vertices[begin + axis] ?? 0) + (vertices[begin + 4 + axis] ?? 0);
      least[axis] = Math.min(least[axis] ?? metres, metres);
      most[axis] = Math.max(most[axis] ?? metres, metres);
    }
    top_m = Math.max(top_m, vertices[begin + HEIGHT] ?? 0);
  }
  const middle = (axis: number): number => ((least[axis] ?? 0) + (most[axis] ?? 0)) / 2;
  const half = (axis: number): number => ((most[axis] ?? 0) - (least[axis] ?? 0)) / 2;
  return {
    centre: [middle(0), middle(1), middle(2)],
    radius_m: Math.hypot(half(0), half(1), half(2)),
    top_m,
  };
}

const least = new Float64Array(3);
const most = new Float64Array(3);

function known(value: number | undefined): number {
  return value === undefined || Number.isNaN(value) ? UNKNOWN : value;
}
