import { writeEcef } from "../../lib/ecef";
import { DEGREES_PER_UNIT, METRES_PER_UNIT, type TrackBlock } from "../../lib/track/block";

/**
 * One point as the graphics processor has it, ten numbers: its earth-centred place in two parts, coarse (with the
 * height behind) and fine (with 1 behind where a piece begins), then speed and climb.
 */
export const POINT_FLOATS = 10;
export const POINT_BYTES = POINT_FLOATS * 4;
/** Stands for a speed or climb that is not known. */
export const UNKNOWN = -1e9;

/** A float32 has seven figures: less than a centimetre of what is left of a place after steps of this many metres. */
const COARSE_M = 65_536;

/** A place in the air, heights over mean sea level. */
export interface Place {
  readonly latitude_deg: number;
  readonly longitude_deg: number;
  readonly altitude_m: number;
}

const place = new Float64Array(3);

export function writePoint(into: Float32Array, at: number, block: TrackBlock, offset: number): void {
  writePlace(into, at, {
    latitude_deg: (block.latitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
    longitude_deg: (block.longitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
    altitude_m: (block.altitude_mm[offset] ?? 0) * METRES_PER_UNIT,
  });
  const begin = at * POINT_FLOATS;
  into[begin + 7] = block.starts.includes(offset) ? 1 : 0;
  into[begin + 8] = known(block.speed_mps[offset]);
  into[begin + 9] = known(block.climb_mps[offset]);
}

/** A place that continues the line, with the speed and climb of the point before it. */
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
  into[begin + 3] = altitude_m;
  into[begin + 7] = 0;
  into[begin + 8] = at === 0 ? UNKNOWN : (into[begin + 8 - POINT_FLOATS] ?? UNKNOWN);
  into[begin + 9] = at === 0 ? UNKNOWN : (into[begin + 9 - POINT_FLOATS] ?? UNKNOWN);
}

/** Earth-centred metres of a point that was written. */
export function placeOf(vertices: Float32Array, at: number): [number, number, number] {
  const part = (axis: number): number =>
    (vertices[at * POINT_FLOATS + axis] ?? 0) + (vertices[at * POINT_FLOATS + 4 + axis] ?? 0);
  return [part(0), part(1), part(2)];
}

/** A ball that holds the first `count` points; looked at in each frame, so nothing is made for each of them. */
export function ballOf(
  vertices: Float32Array,
  count: number,
): { readonly centre: readonly [number, number, number]; readonly radius_m: number } {
  least.fill(Number.POSITIVE_INFINITY);
  most.fill(Number.NEGATIVE_INFINITY);
  for (let begin = 0; begin < count * POINT_FLOATS; begin += POINT_FLOATS) {
    for (let axis = 0; axis < 3; axis += 1) {
      const metres = (vertices[begin + axis] ?? 0) + (vertices[begin + 4 + axis] ?? 0);
      least[axis] = Math.min(least[axis] ?? metres, metres);
      most[axis] = Math.max(most[axis] ?? metres, metres);
    }
  }
  const middle = (axis: number): number => ((least[axis] ?? 0) + (most[axis] ?? 0)) / 2;
  const half = (axis: number): number => ((most[axis] ?? 0) - (least[axis] ?? 0)) / 2;
  return {
    centre: [middle(0), middle(1), middle(2)],
    radius_m: Math.hypot(half(0), half(1), half(2)),
  };
}

const least = new Float64Array(3);
const most = new Float64Array(3);

function known(value: number | undefined): number {
  return value === undefined || Number.isNaN(value) ? UNKNOWN : value;
}
