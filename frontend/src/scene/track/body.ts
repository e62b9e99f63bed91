import type { ThinnedTrack } from "../../lib/track/thinnedTrack";
import { kept, type Thinned } from "../../lib/track/thinning";
import { POINT_FLOATS, writePoint } from "./vertices";

/** From where the track is seen: earth-centred metres, and the angle of one pixel of the picture in radians. */
export interface Eye {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly pixel_rad: number;
}

/** What the finest level strays; each further one may stray twice as much. */
const FINEST_M = 0.05;
const COARSEST = 24;
/** So much of a pixel a line may stray from what was flown. */
const SCREEN_ERROR_PX = 0.8;
/** More points than this are not drawn of one track: levels grow coarser all over instead. */
export const MAX_BODY_POINTS = 60_000;

interface Chosen {
  level: number;
  vertices: Float32Array;
}

/**
 * The complete blocks of a track as one line, each block in the level of detail that its distance from the eye allows.
 * The line is put together again when a block needs another level; whoever draws it copies it then.
 */
export class TrackBody {
  readonly #track: ThinnedTrack;
  readonly #chosen = new WeakMap<Thinned, Chosen>();
  #blocks: readonly Thinned[] = [];
  #vertices = new Float32Array(0);
  #count = 0;
  /** Added to every level while the whole has too many points. */
  #coarser = 0;

  constructor(track: ThinnedTrack) {
    this.#track = track;
  }

  /** `count` points; what is behind them is left from before. */
  get vertices(): Float32Array {
    return this.#vertices;
  }

  get count(): number {
    return this.#count;
  }

  /** The blocks that are in the line, in its order. */
  get blocks(): readonly Thinned[] {
    return this.#blocks;
  }

  /** Chooses the levels for this eye. True: the line is another one now. */
  choose(eye: Eye): boolean {
    const isOther = this.#track.blocks !== this.#blocks;
    if (!isOther && !this.#blocks.some((block) => this.#isWrong(block, eye))) {
      return false;
    }
    this.#blocks = this.#track.blocks;
    this.#coarser = 0;
    this.#take(eye);
    while (this.#count > MAX_BODY_POINTS && this.#coarser < COARSEST) {
      this.#coarser += 1;
      this.#take(eye);
    }
    this.#join();
    return true;
  }

  /** Too coarse at once, too fine only by two levels: a camera that moves to and fro does not change it each time. */
  #isWrong(block: Thinned, eye: Eye): boolean {
    const level = this.#chosen.get(block)?.level ?? -1;
    const wanted = levelOf(block, eye) + this.#coarser;
    return level < 0 || wanted < level || wanted > level + 1;
  }

  #take(eye: Eye): void {
    this.#count = 0;
    for (const block of this.#blocks) {
      const level = levelOf(block, eye) + this.#coarser;
      let chosen = this.#chosen.get(block);
      if (chosen?.level !== level) {
        chosen = { level, vertices: verticesOf(block, FINEST_M * 2 ** level) };
        this.#chosen.set(block, chosen);
      }
      this.#count += chosen.vertices.length / POINT_FLOATS;
    }
  }

  #join(): void {
    if (this.#vertices.length < this.#count * POINT_FLOATS) {
      // Half as much again: a growing track must not need another array with each block.
      this.#vertices = new Float32Array(Math.ceil(this.#count * 1.5) * POINT_FLOATS);
    }
    let at = 0;
    for (const block of this.#blocks) {
      const vertices = this.#chosen.get(block)?.vertices;
      if (vertices !== undefined) {
        this.#vertices.set(vertices, at);
        at += vertices.length;
      }
    }
  }
}

/** The coarsest level whose error is not seen from there. */
function levelOf({ centre, radius_m }: Thinned, { x, y, z, pixel_rad }: Eye): number {
  const distance_m = Math.hypot(centre[0] - x, centre[1] - y, centre[2] - z) - radius_m;
  const error_m = Math.max(0, distance_m) * pixel_rad * SCREEN_ERROR_PX;
  return Math.max(0, Math.min(COARSEST, Math.floor(Math.log2(error_m / FINEST_M))));
}

function verticesOf(thinned: Thinned, tolerance_m: number): Float32Array {
  const offsets = kept(thinned, tolerance_m);
  const vertices = new Float32Array(offsets.length * POINT_FLOATS);
  for (const [at, offset] of offsets.entries()) {
    writePoint(vertices, at, thinned.block, offset);
  }
  return vertices;
}
