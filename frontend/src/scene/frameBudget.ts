/** Weight of the newest frame: some frames decide, not the one in which a shader was compiled. */
const WEIGHT = 0.2;

/** How much of the processor's time frames may take where they are dear. Times in milliseconds. */
export interface BudgetLimits {
  /** A frame dearer than this is drawn by the processor alone; one cheaper than the next, by a graphics processor. */
  readonly dear_ms: number;
  readonly cheap_ms: number;
  /** From the start of a frame to the next, by what a frame costs. */
  readonly shortest_ms: number;
  readonly longest_ms: number;
  /** Of the time between two frames, how much one may take. */
  readonly share: number;
  /** While a person turns the picture it may take more, for as long as that lasts. */
  readonly held: { readonly shortest_ms: number; readonly share: number };
  /** Of a frame that takes longer than the longest time between two: no sooner than so many times its cost. */
  readonly leastRest: number;
}

/**
 * How often something may be drawn. With a graphics processor: in each displayed frame. Without one each frame takes
 * time of the processor that also moves the instruments and runs the gateway: then more seldom, by what a frame costs.
 */
export class FrameBudget {
  readonly #limits: BudgetLimits;
  #cost_ms: number;
  #isDear: boolean;

  /** `startsDear`: what the browser says of its graphics, until frames have told. */
  constructor(startsDear: boolean, limits: BudgetLimits) {
    this.#limits = limits;
    this.#isDear = startsDear;
    this.#cost_ms = startsDear ? limits.dear_ms : 0;
  }

  get isDear(): boolean {
    return this.#isDear;
  }

  /** Least time from the start of one frame to the next; 0: every displayed one. `isHeld`: a person is turning it. */
  period_ms(isHeld: boolean): number {
    if (!this.#isDear) {
      return 0;
    }
    const { held, longest_ms, leastRest } = this.#limits;
    const { shortest_ms, share } = isHeld ? held : this.#limits;
    const wanted_ms = Math.min(longest_ms, Math.max(shortest_ms, this.#cost_ms / share));
    return Math.max(wanted_ms, leastRest * this.#cost_ms);
  }

  /** A frame took so long, from its start until the graphics had finished it. */
  observe(cost_ms: number): void {
    this.#cost_ms += WEIGHT * (cost_ms - this.#cost_ms);
    this.#isDear = this.#cost_ms > (this.#isDear ? this.#limits.cheap_ms : this.#limits.dear_ms);
  }
}
