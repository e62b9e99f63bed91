import type { ThinnedTrack } from "../../lib/track/thinnedTrack";
import { PIECE_POINTS, type Thinned } from "../../lib/track/thinning";
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

interface Chosen {
  /** The level of each piece of the block. */
  readonly levels: Int8Array;
  readonly vertices: Float32Array;
}

/**
 * The complete blocks of a track as one line, each piece in the level of detail that its distance from the camera
 * allows. The line is rebuilt when a piece needs another level; its user copies it then.
 */
export class TrackBody {
  readonly #track: ThinnedTrack;
  readonly #chosen = new WeakMap<Thinned, Chosen>();
  #blocks: readonly Thinned[] = [];
  #vertices = new Float32Array(0);
  #count = 0;
  #starts: readonly number[] = [];
  #eye: Eye | null = null;
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

  /** Index of each block's first point in the line. */
  get starts(): readonly number[] {
    return this.#starts;
  }

  /** The blocks of the line, in order. */
  get blocks(): readonly Thinned[] {
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
    if (!isOther && this.#isComplete && isSame(eye, this.#eye)) {
      return false;
    }
    this.#eye = eye;
    this.#blocks = this.#track.blocks;
    const wrong = this.#blocks.filter((block) => this.#isWrong(block, eye, 0));
    this.#isComplete = true;
    if (!isOther && wrong.length === 0) {
      return false;
    }
    if (this.#coarser > 0) {
      this.#coarser = 0;
      this.#take(this.#blocks, eye);
    } else {
      // The others stay: a moving camera would otherwise change half of them for each picture.
      this.#take(wrong, eye, isEnough);
    }
    while (this.#count > MAX_BODY_POINTS && this.#coarser < COARSEST) {
      this.#coarser += 1;
      this.#take(this.#blocks, eye);
    }
    this.#join();
    return true;
  }

  /**
   * Too coarse is corrected at once, too fine only from two levels on: a camera that moves back and forth must not
   * change it each time.
   */
  #isWrong(block: Thinned, eye: Eye, room: number): boolean {
    const levels = this.#chosen.get(block)?.levels;
    if (levels === undefined) {
      return true;
    }
    const [nearest, farthest] = levelsOf(block.centre, block.radius_m, eye);
    for (let piece = 0; piece < levels.length; piece += 1) {
      const wanted = (nearest === farthest ? nearest : pieceLevel(block, piece, eye)) + this.#coarser;
      const level = levels[piece] ?? 0;
      if (wanted < level - room || wanted > level + 1 + room) {
        return true;
      }
    }
    return false;
  }

  #take(blocks: readonly Thinned[], eye: Eye, isEnough: () => boolean = () => false): void {
    let taken = 0;
    for (const block of blocks) {
      // At least one per picture, or it would never end.
      if (taken > 0 && isEnough() && !this.#isWrong(block, eye, LITTLE)) {
        this.#isComplete = false;
        continue;
      }
      taken += 1;
      const levels = new Int8Array(block.pieces_m.length / 4);
      for (let piece = 0; piece < levels.length; piece += 1) {
        levels[piece] = pieceLevel(block, piece, eye) + this.#coarser;
      }
      this.#chosen.set(block, { levels, vertices: verticesOf(block, levels) });
    }
    this.#count = 0;
    for (const block of this.#blocks) {
      this.#count += (this.#chosen.get(block)?.vertices.length ?? 0) / POINT_FLOATS;
    }
  }

  #join(): void {
    if (this.#vertices.length < this.#count * POINT_FLOATS) {
      // Half as much again, so that a growing track does not need a new array for each block.
      this.#vertices = new Float32Array(Math.ceil(this.#count * 1.5) * POINT_FLOATS);
    }
    const starts: number[] = [];
    let at = 0;
    for (const block of this.#blocks) {
      starts.push(at / POINT_FLOATS);
      const vertices = this.#chosen.get(block)?.vertices;
      if (vertices !== undefined) {
        this.#vertices.set(vertices, at);
        at += vertices.length;
      }
    }
    this.#starts = starts;
  }
}

function isSame(one: Eye, other: Eye | null): boolean {
  return one.x === other?.x && one.y === other.y && one.z === other.z && one.stray_rad === other.stray_rad;
}

/** The coarsest levels whose error is invisible, at the nearest and the farthest point of a sphere. */
function levelsOf(
  [atX, atY, atZ]: readonly [number, number, number],
  radius_m: number,
  { x, y, z, stray_rad }: Eye,
): readonly [number, number] {
  const distance_m = Math.hypot(atX - x, atY - y, atZ - z);
  const level = (far_m: number): number => {
    const error_m = Math.max(0, far_m) * stray_rad;
    return Math.max(0, Math.min(COARSEST, Math.floor(Math.log2(error_m / FINEST_M))));
  };
  return [level(distance_m - radius_m), level(distance_m + radius_m)];
}

function pieceLevel({ pieces_m }: Thinned, piece: number, eye: Eye): number {
  const part = (axis: number): number => pieces_m[4 * piece + axis] ?? 0;
  return levelsOf([part(0), part(1), part(2)], part(3), eye)[0];
}

/** Where the level changes, the line passes through a flown point of both levels, so that there is no gap. */
function verticesOf({ block, keep_m }: Thinned, levels: Int8Array): Float32Array {
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
