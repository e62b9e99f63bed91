const FRAME_MS = 1000 / 60;
/** Of the page's main thread, for frames in which something moves. */
const SHARE = 0.16;
/** It moves more often again when that would take this much less than its share. */
const SPARE = 0.75;
/** In every third frame at the least: twenty times a second still reads as movement. */
const FRAMES_MOST = 3;
/** A frame may come early by this much. */
const EARLY_MS = 4;
/** Weight of the newest frame: half a second of frames decides, not one slow one. */
const WEIGHT = 0.05;

/**
 * How often the instruments may move. With a graphics processor a frame costs the page a millisecond or two and they
 * move in each; drawn by the processor alone it costs several, and the aircraft's other programs want that time.
 */
export class RedrawBudget {
  #cost_ms = 0;
  #frames = 1;

  /** Least time between two movements, in milliseconds; 0: every frame. */
  get period_ms(): number {
    return this.#frames === 1 ? 0 : this.#frames * FRAME_MS - EARLY_MS;
  }

  /** A frame in which instruments moved took so long, from its start until the page was free again. */
  observe(cost_ms: number): void {
    this.#cost_ms += WEIGHT * (cost_ms - this.#cost_ms);
    if (this.#frames < FRAMES_MOST && this.#cost_ms > this.#frames * FRAME_MS * SHARE) {
      this.#frames += 1;
    } else if (this.#frames > 1 && this.#cost_ms < (this.#frames - 1) * FRAME_MS * SHARE * SPARE) {
      this.#frames -= 1;
    }
  }
}
