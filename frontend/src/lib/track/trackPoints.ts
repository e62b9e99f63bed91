import { METRES_PER_DEGREE } from "../geodesy";
import { BLOCK_BITS, BLOCK_POINTS, DEGREES_PER_UNIT, METRES_PER_UNIT, merged, TrackBlock } from "./block";

/**
 * 786,432 points: 4 h 22 min at 50 Hz, 22 MB. Beyond it every second one of the older points is dropped, block by
 * block.
 */
export const MAX_BLOCKS = 768;

// As at the gateway: after a longer gap, the flight between the points is unknown.
const LONGEST_GAP_S = 10;
const FASTEST_MPS = 350;
const LEAST_JUMP_M = 100;

/**
 * Speed and climb are averaged over this time: one step of 1e-7 degrees (1 cm) between two points at 50 Hz would be
 * 0.6 m/s.
 */
const WINDOW_S = 1.5;
/** A shorter time is too inaccurate. */
const LEAST_WINDOW_S = 0.5;

/** The least and greatest of a track's values; null if there is none. */
export interface ValueRange {
  readonly least: number;
  readonly most: number;
}

/** One point as received. */
export interface TrackPoint {
  readonly t_s: number;
  readonly latitude_e7: number;
  readonly longitude_e7: number;
  readonly altitude_mm: number;
}

/** One track in order of time, in bounded memory. Adding a point costs the same at any length. */
export class TrackPoints {
  #blocks: TrackBlock[] = [];
  #count = 0;
  #revision = 0;
  /** The block to thin next when memory is full. */
  #thinning = 0;
  readonly #maxBlocks: number;
  /** Index of the first point in the window of the newest point's speed. */
  #window = 0;
  #altitude: ValueRange | null = null;
  #speed: ValueRange | null = null;
  #climb: ValueRange | null = null;

  constructor(maxBlocks = MAX_BLOCKS) {
    this.#maxBlocks = maxBlocks;
  }

  /** All but the newest are full. */
  get blocks(): readonly TrackBlock[] {
    return this.#blocks;
  }

  get count(): number {
    return this.#count;
  }

  /** Changes with every change. */
  get revision(): number {
    return this.#revision;
  }

  get altitude_m(): ValueRange | null {
    return this.#altitude;
  }

  get speed_mps(): ValueRange | null {
    return this.#speed;
  }

  get climb_mps(): ValueRange | null {
    return this.#climb;
  }

  get first_s(): number | null {
    return this.#blocks[0]?.t_s[0] ?? null;
  }

  get last_s(): number | null {
    const block = this.#blocks.at(-1);
    return block?.t_s[block.count - 1] ?? null;
  }

  clear(): void {
    this.#blocks = [];
    this.#count = 0;
    this.#revision += 1;
    this.#thinning = 0;
    this.#window = 0;
    this.#altitude = null;
    this.#speed = null;
    this.#climb = null;
  }

  add(point: TrackPoint): void {
    const before = this.#blocks.at(-1);
    const begins = before === undefined || isInterrupted(before, before.count - 1, point);
    const block = before === undefined || before.isFull ? this.#nextBlock() : before;
    const offset = block.count;
    block.t_s[offset] = point.t_s;
    block.latitude_e7[offset] = point.latitude_e7;
    block.longitude_e7[offset] = point.longitude_e7;
    block.altitude_mm[offset] = point.altitude_mm;
    block.count += 1;
    this.#count += 1;
    this.#revision += 1;
    if (begins) {
      block.starts.push(offset);
      this.#window = this.#count - 1;
    }
    this.#rate(block, offset);
    this.#altitude = widened(this.#altitude, point.altitude_mm * METRES_PER_UNIT);
  }

  #nextBlock(): TrackBlock {
    if (this.#blocks.length >= this.#maxBlocks) {
      this.#thin();
    }
    const block = new TrackBlock();
    this.#blocks.push(block);
    return block;
  }

  /** Merges two old blocks: a thousandth of the work of thinning the whole older half at once. */
  #thin(): void {
    const at = this.#thinning;
    const [first, second] = [this.#blocks[at], this.#blocks[at + 1]];
    if (first === undefined || second === undefined) {
      return;
    }
    const block = merged(first, second);
    this.#blocks.splice(at, 2, block);
    this.#count -= BLOCK_POINTS;
    this.#thinning = at + 2 >= this.#maxBlocks / 2 ? 0 : at + 1;
    const begin = at * BLOCK_POINTS;
    const beyond = this.#window - begin;
    this.#window -= beyond >= 2 * BLOCK_POINTS ? BLOCK_POINTS : Math.max(0, Math.ceil(beyond / 2));
  }

  /** Speed and climb over the time before this point, within its piece. */
  #rate(block: TrackBlock, offset: number): void {
    const t_s = block.t_s[offset] ?? 0;
    while (this.#window + 2 < this.#count && t_s - this.#time(this.#window + 1) >= WINDOW_S) {
      this.#window += 1;
    }
    const start = this.#blocks[this.#window >> BLOCK_BITS] ?? block;
    const from = this.#window & (BLOCK_POINTS - 1);
    const elapsed_s = t_s - (start.t_s[from] ?? 0);
    if (elapsed_s < LEAST_WINDOW_S) {
      block.speed_mps[offset] = Number.NaN;
      block.climb_mps[offset] = Number.NaN;
      return;
    }
    const speed_mps = moved_m(start, from, block, offset) / elapsed_s;
    const risen_mm = (block.altitude_mm[offset] ?? 0) - (start.altitude_mm[from] ?? 0);
    const climb_mps = (risen_mm * METRES_PER_UNIT) / elapsed_s;
    block.speed_mps[offset] = speed_mps;
    block.climb_mps[offset] = climb_mps;
    this.#speed = widened(this.#speed, speed_mps);
    this.#climb = widened(this.#climb, climb_mps);
  }

  #time(index: number): number {
    return this.#blocks[index >> BLOCK_BITS]?.t_s[index & (BLOCK_POINTS - 1)] ?? 0;
  }
}

function widened(spread: ValueRange | null, value: number): ValueRange {
  if (spread === null) {
    return { least: value, most: value };
  }
  return value < spread.least || value > spread.most
    ? { least: Math.min(spread.least, value), most: Math.max(spread.most, value) }
    : spread;
}

/** Whether the flight between a block's last point and this one is unknown. */
export function isInterrupted(block: TrackBlock, last: number, point: TrackPoint): boolean {
  const elapsed_s = point.t_s - (block.t_s[last] ?? 0);
  return (
    // If the clock was set back, the elapsed time is unknown.
    elapsed_s < 0 ||
    elapsed_s > LONGEST_GAP_S ||
    flat_m(
      block.latitude_e7[last] ?? 0,
      block.longitude_e7[last] ?? 0,
      point.latitude_e7,
      point.longitude_e7,
    ) > Math.max(LEAST_JUMP_M, FASTEST_MPS * elapsed_s)
  );
}

function moved_m(from: TrackBlock, start: number, to: TrackBlock, end: number): number {
  return flat_m(
    from.latitude_e7[start] ?? 0,
    from.longitude_e7[start] ?? 0,
    to.latitude_e7[end] ?? 0,
    to.longitude_e7[end] ?? 0,
  );
}

/** Distance of two near positions, also across the date line. */
function flat_m(latitude_e7: number, longitude_e7: number, toLatitude_e7: number, toLongitude_e7: number) {
  const north_deg = (toLatitude_e7 - latitude_e7) * DEGREES_PER_UNIT;
  const turn_e7 = toLongitude_e7 - longitude_e7;
  const east_e7 = turn_e7 > 1.8e9 ? turn_e7 - 3.6e9 : turn_e7 < -1.8e9 ? turn_e7 + 3.6e9 : turn_e7;
  const east_deg = east_e7 * DEGREES_PER_UNIT * Math.cos((latitude_e7 * DEGREES_PER_UNIT * Math.PI) / 180);
  return Math.hypot(north_deg, east_deg) * METRES_PER_DEGREE;
}
