/** A frame dearer than the first is drawn by the processor alone; one cheaper than the second, by a graphics processor. */
const DEAR_MS = 45;
const CHEAP_MS = 20;
/** Weight of the newest frame: some frames decide, not the one in which a shader was compiled. */
const WEIGHT = 0.2;
/** Where frames are dear: between two and five in a second, with this share of the time between. */
const SHORTEST_MS = 200;
const LONGEST_MS = 500;
const SHARE = 0.35;
/** While a person turns the globe it may take more, for as long as that lasts. */
const HELD_SHORTEST_MS = 100;
const HELD_SHARE = 0.6;
/** Of a frame that takes longer than the longest time between two: as much is left to all else. */
const LEAST_REST = 1.5;

/**
 * How often the globe may be drawn. With a graphics processor: in each displayed frame. Without one a frame costs
 * tenths of a second of the processor that also moves the instruments and runs the gateway: then two to five times a
 * second, by what a frame costs.
 */
export class FrameBudget {
  #cost_ms: number;
  #isDear: boolean;

  /** `startsDear`: what the browser says of its graphics, until frames have told. */
  constructor(startsDear: boolean) {
    this.#isDear = startsDear;
    this.#cost_ms = startsDear ? DEAR_MS : 0;
  }

  get isDear(): boolean {
    return this.#isDear;
  }

  /** Least time from the start of one frame to the next; 0: every displayed one. `isHeld`: a person is turning the globe. */
  period_ms(isHeld: boolean): number {
    if (!this.#isDear) {
      return 0;
    }
    const [shortest_ms, share] = isHeld ? [HELD_SHORTEST_MS, HELD_SHARE] : [SHORTEST_MS, SHARE];
    const wanted_ms = Math.min(LONGEST_MS, Math.max(shortest_ms, this.#cost_ms / share));
    return Math.max(wanted_ms, LEAST_REST * this.#cost_ms);
  }

  /** A frame took so long, from its start until the graphics had finished it. */
  observe(cost_ms: number): void {
    this.#cost_ms += WEIGHT * (cost_ms - this.#cost_ms);
    this.#isDear = this.#cost_ms > (this.#isDear ? CHEAP_MS : DEAR_MS);
  }
}
