import type { TrackBlock } from "./block";
import { thin, type WeightedBlock } from "./thinning";
import type { TrackPoints } from "./trackPoints";

/**
 * The complete blocks of a track with their levels of detail. They are computed a few at a time: two hours that
 * arrive at once must not freeze the page.
 */
export class ThinnedTrack {
  readonly #points: TrackPoints;
  readonly #made = new WeakMap<TrackBlock, WeightedBlock>();
  #blocks: readonly WeightedBlock[] = [];
  #revision = -1;
  #isComplete = false;

  constructor(points: TrackPoints) {
    this.#points = points;
  }

  /** In order of time without a gap: the newest of the complete blocks. */
  get blocks(): readonly WeightedBlock[] {
    return this.#blocks;
  }

  get points(): TrackPoints {
    return this.#points;
  }

  /** Computes missing ones, the newest first, until `isEnough`. Returns whether the list has changed. */
  refresh(isEnough: () => boolean): boolean {
    if (this.#revision === this.#points.revision && this.#isComplete) {
      return false;
    }
    this.#revision = this.#points.revision;
    const { blocks } = this.#points;
    const complete = blocks.length - (blocks.at(-1)?.isFull === false ? 1 : 0);
    const found: WeightedBlock[] = [];
    let at = complete - 1;
    for (; at >= 0; at -= 1) {
      const block = blocks[at];
      const made = block && (this.#made.get(block) ?? (isEnough() ? undefined : this.#make(block)));
      if (made === undefined) {
        break;
      }
      found.push(made);
    }
    this.#isComplete = at < 0;
    found.reverse();
    const isSame = found.length === this.#blocks.length && found.every((one, i) => one === this.#blocks[i]);
    this.#blocks = isSame ? this.#blocks : found;
    return !isSame;
  }

  #make(block: TrackBlock): WeightedBlock {
    const made = thin(block);
    this.#made.set(block, made);
    return made;
  }

  /** Whether none is missing. */
  get isComplete(): boolean {
    return this.#isComplete && this.#revision === this.#points.revision;
  }
}
