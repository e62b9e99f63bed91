import type { ThinnedTrack } from "../../lib/track/thinnedTrack";
import { PIECE_POINTS, type WeightedBlock } from "../../lib/track/thinning";
import { POINT_FLOATS } from "../ribbon/vertices";
import { writePoint } from "./writePoint";

/**
 * The camera's position, earth-centred metres, and the angle, radians, by which a line may deviate from the flown
 * one.
 */
export interface Eye {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly stray_rad: number;
}

/** Deviation of the finest level; each further level has twice as much. */
const FINEST_M = 0.05;
const COARSEST = 24;
/** Greatest number of drawn points of one track: beyond it all levels become coarser. */
export const MAX_BODY_POINTS = 60_000;

/** A piece that is wrong by up to this many levels may wait: its error is twice the allowed one. */
const LITTLE = 1;

/** The levels follow a flying camera in every so many pictures: at 30 m/s they change by little from one to the next. */
const PICTURES = 4;
/** A step as long as this is a jump: everything may look different. */
const JUMP_M = 50;

interface Chosen {
  /** The level of each piece of the block. */
  readonly levels: Int8Array;
  readonly vertices: Float32Array;
}

/**
 * The complete blocks of a track as one line, each piece in the level of detail that its distance from the camera
 * allows. The line is rebuilt when a piece needs another level; its user copies it then, from `changed` on.
 */
export class TrackBody {
  readonly #track: ThinnedTrack;
  readonly #chosen = new WeakMap<WeightedBlock, Chosen>();
  #blocks: readonly WeightedBlock[] = [];
  #vertices = new Float32Array(0);
  #count = 0;
  #starts: readonly number[] = [];
  #joined: readonly Chosen[] = [];
  #changed = 0;
  /** The cameras of the last choice and of the last picture. */
  #eye: Eye | null = null;
  #seen: Eye | null = null;
  #waited = 0;
  /** Length of the camera's way. */
  #travelled_m = 0;
  /** For each block, the length of that way from which on one of its levels may be wrong. */
  #wrongFrom_m = new Float64Array(0);
  #isComplete = true;
  /** Added to every level while there are too many points. */
  #coarser = 0;

  constructor(track: ThinnedTrack) {
    this.#track = track;
  }

  /** `count` points; the rest of the array is old. */
  get vertices(): Float32Array {
    return this.#vertices;
  }

  get count(): number {
    return this.#count;
  }

  /** Index of the first point that the last choice changed. */
  get changed(): number {
    return this.#changed;
  }

  /** Index of each block's first point in the line. */
  get starts(): readonly number[] {
    return this.#starts;
  }

  /** The blocks of the line, in order. */
  get blocks(): readonly WeightedBlock[] {
    return this.#blocks;
  }

  /** Whether every block has the right levels for the last camera. */
  get isComplete(): boolean {
    return this.#isComplete;
  }

  /**
   * Chooses the levels for this camera. Returns whether the line has changed. `isEnough` may leave small errors for
   * later.
   */
  choose(eye: Eye, isEnough: () => boolean = () => false): boolean {
    const isOther = this.#track.blocks !== this.#blocks;
    if (!isOther && this.#mayWait(eye)) {
      return false;
    }
    if (isOther) {
      this.#blocks = this.#track.blocks;
      this.#count = this.#blocks.reduce((sum, block) => sum + this.#pointsOf(block), 0);
    }
    const wrong = this.#wrong(eye, isOther);
    this.#isComplete = true;
    if (!isOther && wrong.length === 0) {
      return false;
    }
    if (this.#coarser > 0) {
      this.#coarser = 0;
      this.#takeAll(eye);
    } else {
      // The others stay: a moving camera would otherwise change half of them for each picture.
      this.#take(wrong, eye, isEnough);
    }
    while (this.#count > MAX_BODY_POINTS && this.#coarser < COARSEST) {
      this.#coarser += 1;
      this.#takeAll(eye);
    }
    this.#join();
    return true;
  }

  /** Whether the line may stay as it is for this picture. A resting camera soon has the right levels. */
  #mayWait(eye: Eye): boolean {
    const [last, chosen] = [this.#seen, this.#eye];
    this.#seen = eye;
    if (isSame(eye, last)) {
      return this.#isComplete;
    }
    this.#waited += 1;
    if (
      chosen === null ||
      this.#waited >= PICTURES ||
      hasZoomed(eye, chosen) ||
      apart_m(eye, chosen) > JUMP_M
    ) {
      return false;
    }
    this.#isComplete = false;
    return true;
  }

  /** Looks from this camera: the blocks with a wrong level. Most are too far away for its last steps to matter. */
  #wrong(eye: Eye, isOther: boolean): readonly WeightedBlock[] {
    const last = this.#eye ?? eye;
    this.#eye = eye;
    this.#waited = 0;
    this.#travelled_m += apart_m(eye, last);
    const travelled_m = this.#travelled_m;
    if (isOther || hasZoomed(eye, last)) {
      this.#wrongFrom_m = new Float64Array(this.#blocks.length);
    }
    const wrongFrom_m = this.#wrongFrom_m;
    return this.#blocks.filter((block, index) => {
      if ((wrongFrom_m[index] ?? 0) > travelled_m) {
        return false;
      }
      const room_m = this.#room_m(block, eye, 0);
      wrongFrom_m[index] = travelled_m + room_m;
      return room_m < 0;
    });
  }

  /**
   * How far the camera can go in any direction until a level is wrong; negative if one is. Too coarse is wrong by one
   * level, too fine only by two: a camera that moves back and forth must not change it each time. `slack`: levels by
   * which it may be wrong.
   */
  #room_m(block: WeightedBlock, eye: Eye, slack: number): number {
    const chosen = this.#chosen.get(block);
    if (chosen === undefined) {
      return Number.NEGATIVE_INFINITY;
    }
    let room_m = Number.POSITIVE_INFINITY;
    for (const [piece, level] of chosen.levels.entries()) {
      const near_m = nearest_m(block, piece, eye);
      const own = level - this.#coarser;
      room_m = Math.min(room_m, near_m - reach_m(own - slack, eye), reach_m(own + 2 + slack, eye) - near_m);
    }
    return room_m;
  }

  #takeAll(eye: Eye): void {
    this.#wrongFrom_m.fill(0);
    this.#take(this.#blocks, eye);
  }

  #take(blocks: readonly WeightedBlock[], eye: Eye, isEnough: () => boolean = () => false): void {
    let taken = 0;
    for (const block of blocks) {
      // At least one per picture, or it would never end.
      if (taken > 0 && isEnough() && this.#room_m(block, eye, LITTLE) >= 0) {
        this.#isComplete = false;
        continue;
      }
      taken += 1;
      const levels = new Int8Array(block.pieces_m.length / 4);
      for (let piece = 0; piece < levels.length; piece += 1) {
        levels[piece] = pieceLevel(block, piece, eye) + this.#coarser;
      }
      const vertices = verticesOf(block, levels);
      this.#count -= this.#pointsOf(block);
      this.#chosen.set(block, { levels, vertices });
      this.#count += this.#pointsOf(block);
    }
  }

  #pointsOf(block: WeightedBlock): number {
    return (this.#chosen.get(block)?.vertices.length ?? 0) / POINT_FLOATS;
  }

  /** Writes the line from the first block on that is another one now. */
  #join(): void {
    const before = this.#joined;
    this.#joined = this.#blocks.flatMap((block) => this.#chosen.get(block) ?? []);
    let from = this.#joined.findIndex((chosen, index) => chosen !== before[index]);
    from = from === -1 ? this.#joined.length : from;
    if (this.#vertices.length < this.#count * POINT_FLOATS) {
      // Half as much again, so that a growing track does not need a new array for each block.
      this.#vertices = new Float32Array(Math.ceil(this.#count * 1.5) * POINT_FLOATS);
      from = 0;
    }
    const starts = this.#starts.slice(0, from);
    let at =
      from === 0 ? 0 : (starts[from - 1] ?? 0) * POINT_FLOATS + (before[from - 1]?.vertices.length ?? 0);
    this.#changed = at / POINT_FLOATS;
    for (const { vertices } of this.#joined.slice(from)) {
      starts.push(at / POINT_FLOATS);
      this.#vertices.set(vertices, at);
      at += vertices.length;
    }
    this.#starts = starts;
  }
}

function isSame(one: Eye, other: Eye | null): boolean {
  return other !== null && apart_m(one, other) === 0 && !hasZoomed(one, other);
}

function hasZoomed(one: Eye, other: Eye): boolean {
  return one.stray_rad !== other.stray_rad;
}

function apart_m(one: Eye, other: Eye): number {
  return Math.hypot(one.x - other.x, one.y - other.y, one.z - other.z);
}

/** From this distance on, a level's error is invisible: from any for the finest, from none beyond the coarsest. */
function reach_m(level: number, { stray_rad }: Eye): number {
  if (level <= 0) {
    return Number.NEGATIVE_INFINITY;
  }
  return level > COARSEST ? Number.POSITIVE_INFINITY : (FINEST_M * 2 ** level) / stray_rad;
}

/** From the camera to the nearest point of a piece; negative inside its sphere. */
function nearest_m({ pieces_m }: WeightedBlock, piece: number, { x, y, z }: Eye): number {
  const part = (axis: number): number => pieces_m[4 * piece + axis] ?? 0;
  return Math.hypot(part(0) - x, part(1) - y, part(2) - z) - part(3);
}

/** The coarsest level whose error is invisible at the nearest point of a piece. */
function pieceLevel(block: WeightedBlock, piece: number, eye: Eye): number {
  const error_m = Math.max(0, nearest_m(block, piece, eye)) * eye.stray_rad;
  return Math.max(0, Math.min(COARSEST, Math.floor(Math.log2(error_m / FINEST_M))));
}

/** Where the level changes, the line passes through a flown point of both levels, so that there is no gap. */
function verticesOf({ block, keep_m }: WeightedBlock, levels: Int8Array): Float32Array {
  const offsets: number[] = [];
  for (const [piece, level] of levels.entries()) {
    const begin = piece * PIECE_POINTS;
    const end = Math.min(keep_m.length, begin + PIECE_POINTS);
    const tolerance_m = FINEST_M * 2 ** level;
    const isOther = piece > 0 && levels[piece - 1] !== level;
    for (let offset = begin; offset < end; offset += 1) {
      if ((keep_m[offset] ?? 0) > tolerance_m || (isOther && offset === begin)) {
        offsets.push(offset);
      }
    }
  }
  const vertices = new Float32Array(offsets.length * POINT_FLOATS);
  for (const [at, offset] of offsets.entries()) {
    writePoint(vertices, at, block, offset);
  }
  return vertices;
}
