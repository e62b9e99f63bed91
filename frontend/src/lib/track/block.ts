/** Points of one block: twenty seconds at 50 Hz. Complete blocks are thinned one by one. */
export const BLOCK_BITS = 10;
export const BLOCK_POINTS = 1 << BLOCK_BITS;

/** One unit of the wire's coordinates. */
export const DEGREES_PER_UNIT = 1e-7;
export const METRES_PER_UNIT = 1e-3;

/** Consecutive points of a track, 28 bytes each. A full block never changes again. */
export class TrackBlock {
  /** Unix seconds of the gateway's clock. */
  readonly t_s = new Float64Array(BLOCK_POINTS);
  /** 1e-7 degrees, north and east positive. */
  readonly latitude_e7 = new Int32Array(BLOCK_POINTS);
  readonly longitude_e7 = new Int32Array(BLOCK_POINTS);
  /** Over mean sea level. */
  readonly altitude_mm = new Int32Array(BLOCK_POINTS);
  /** Over ground, and upwards; NaN if the track before is too short to compute it. */
  readonly speed_mps = new Float32Array(BLOCK_POINTS);
  readonly climb_mps = new Float32Array(BLOCK_POINTS);
  /** Offsets at which a new piece begins: the flight between it and the point before is unknown. */
  readonly starts: number[] = [];
  count = 0;

  get isFull(): boolean {
    return this.count === BLOCK_POINTS;
  }
}

/**
 * Two consecutive blocks merged into one by taking every second point; keeps the very first point and the beginning
 * of each piece.
 */
export function merged(first: TrackBlock, second: TrackBlock): TrackBlock {
  const into = new TrackBlock();
  for (const from of [first, second]) {
    const before = into.count;
    for (let offset = 0; offset < from.count; offset += 2) {
      copyPoint(from, offset, into, into.count);
      into.count += 1;
    }
    for (const start of from.starts) {
      const at = before + Math.ceil(start / 2);
      // A piece of a single point at an odd index is dropped; the next piece begins in its place.
      if (at < BLOCK_POINTS && into.starts.at(-1) !== at) {
        into.starts.push(at);
      }
    }
  }
  return into;
}

function copyPoint(from: TrackBlock, offset: number, into: TrackBlock, at: number): void {
  into.t_s[at] = from.t_s[offset] ?? 0;
  into.latitude_e7[at] = from.latitude_e7[offset] ?? 0;
  into.longitude_e7[at] = from.longitude_e7[offset] ?? 0;
  into.altitude_mm[at] = from.altitude_mm[offset] ?? 0;
  into.speed_mps[at] = from.speed_mps[offset] ?? 0;
  into.climb_mps[at] = from.climb_mps[offset] ?? 0;
}
