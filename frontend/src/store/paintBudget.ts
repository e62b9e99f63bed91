const ANIMATION_FRAME_MS = 1000 / 60;
/** Share of the main thread's time for animation frames in which something moves. */
const SHARE = 0.16;
/** Hysteresis: speed up only below 75 % of the budget. */
const SPARE = 0.75;
/** Every third animation frame. Twenty a second still looks like movement. */
const SLOWEST = 3;
/** Tolerance for an early animation frame. */
const EARLY_MS = 4;
/** Weight of the newest measurement: the average spans half a second, so that one slow animation frame does not decide. */
const WEIGHT = 0.05;

/**
 * Limits how often the instruments move. With a graphics processor an animation frame costs the page a millisecond or
 * two and they move in each; without one it costs several, and that time is needed by the simulator and the gateway.
 */
export class RedrawBudget {
  #cost_ms = 0;
  /** Instruments move in every nth animation frame. */
  #nth = 1;

  /** Shortest time between two movements, milliseconds; 0: every animation frame. */
  get period_ms(): number {
    return this.#nth === 1 ? 0 : this.#nth * ANIMATION_FRAME_MS - EARLY_MS;
  }

  /** Note the cost of an animation frame in which instruments moved, from its start until the page was idle. */
  observe(cost_ms: number): void {
    this.#cost_ms += WEIGHT * (cost_ms - this.#cost_ms);
    if (this.#nth < SLOWEST && this.#cost_ms > this.#nth * ANIMATION_FRAME_MS * SHARE) {
      this.#nth += 1;
    } else if (this.#nth > 1 && this.#cost_ms < (this.#nth - 1) * ANIMATION_FRAME_MS * SHARE * SPARE) {
      this.#nth -= 1;
    }
  }
}
