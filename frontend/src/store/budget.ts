/** Main-thread time of one displayed frame from which instruments move in every second frame only, and back. */
const DEAR_MS = 5;
const CHEAP_MS = 3;
/** Weight of the newest frame: half a second of frames decides, not one slow one. */
const WEIGHT = 0.05;
/** Every second frame of 60 Hz, less what a frame may come early. */
const HALF_RATE_MS = 1000 / 30 - 4;

/**
 * How often the instruments may move. With a graphics processor a frame costs the page a millisecond or two and they
 * move in each; drawn by the processor alone it costs several, and the aircraft's other programs want that time.
 */
export class RedrawBudget {
  #cost_ms = 0;
  #isDear = false;

  /** Least time between two movements, in milliseconds; 0: every frame. */
  get period_ms(): number {
    return this.#isDear ? HALF_RATE_MS : 0;
  }

  /** A frame in which instruments moved took so long, from its start until the page was free again. */
  observe(cost_ms: number): void {
    this.#cost_ms += WEIGHT * (cost_ms - this.#cost_ms);
    this.#isDear = this.#cost_ms > (this.#isDear ? CHEAP_MS : DEAR_MS);
  }
}
