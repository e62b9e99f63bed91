/** A frame dearer than this is drawn by the processor alone; a cheaper one than the second, by a graphics processor. */
const DEAR_MS = 40;
const CHEAP_MS = 18;
/** Weight of the newest frame: some frames decide, not the one in which a shader was compiled. */
const WEIGHT = 0.25;
/** Where frames are dear: between two and five in a second, and no more than this share of the time. */
const MINIMUM_PERIOD_MS = 200;
const MAXIMUM_PERIOD_MS = 500;
const SHARE = 0.35;
/** While a person turns the globe it may take more, for as long as that lasts. */
const HELD_PERIOD_MS = 100;
const HELD_SHARE = 0.6;

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

  /** What a frame costs at present, from its start until the graphics have finished it. */
  get cost_ms(): number {
    return this.#cost_ms;
  }

  /** Least time between two frames; 0: every displayed one. `isHeld`: a person is turning the globe. */
  period_ms(isHeld: boolean): number {
    if (!this.#isDear) {
      return 0;
    }
    const wanted_ms = this.#cost_ms / (isHeld ? HELD_SHARE : SHARE);
    return Math.min(MAXIMUM_PERIOD_MS, Math.max(isHeld ? HELD_PERIOD_MS : MINIMUM_PERIOD_MS, wanted_ms));
  }

  observe(cost_ms: number): void {
    this.#cost_ms += WEIGHT * (cost_ms - this.#cost_ms);
    this.#isDear = this.#cost_ms > (this.#isDear ? CHEAP_MS : DEAR_MS);
  }
}
