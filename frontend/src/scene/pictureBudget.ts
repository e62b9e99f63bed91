/** Weight of the newest measurement: several pictures decide, not the one in which a shader was compiled. */
const WEIGHT = 0.2;

/** The share of time that pictures may take on slow graphics. Times in milliseconds. */
export interface BudgetLimits {
  /**
   * A picture that costs more than this was drawn by the processor; one that costs less than the next, by a graphics
   * processor.
   */
  readonly dear_ms: number;
  readonly cheap_ms: number;
  /** Limits of the period, from the start of a picture to the next, by a picture's cost. */
  readonly shortest_ms: number;
  readonly longest_ms: number;
  /** Share of the period that a picture may take. */
  readonly share: number;
  /** Larger share while the user turns the picture. */
  readonly held: { readonly shortest_ms: number; readonly share: number };
  /**
   * For a picture that takes longer than the longest period: the next starts no sooner than this many times its cost.
   */
  readonly leastRest: number;
}

/**
 * Limits how often something is drawn. With a graphics processor: in each animation frame. Without one, pictures take
 * time of the processor that also moves the instruments and runs the gateway: less often, depending on a picture's
 * cost.
 */
export class PictureBudget {
  readonly #limits: BudgetLimits;
  #cost_ms: number;
  #isDear: boolean;

  /** `startsDear`: what the browser reports of its graphics, until pictures are measured. */
  constructor(startsDear: boolean, limits: BudgetLimits) {
    this.#limits = limits;
    this.#isDear = startsDear;
    this.#cost_ms = startsDear ? limits.dear_ms : 0;
  }

  get isDear(): boolean {
    return this.#isDear;
  }

  /** Shortest period between pictures; 0: every animation frame. `isHeld`: the user is turning it. */
  period_ms(isHeld: boolean): number {
    if (!this.#isDear) {
      return 0;
    }
    const { held, longest_ms, leastRest } = this.#limits;
    const { shortest_ms, share } = isHeld ? held : this.#limits;
    const wanted_ms = Math.min(longest_ms, Math.max(shortest_ms, this.#cost_ms / share));
    return Math.max(wanted_ms, leastRest * this.#cost_ms);
  }

  /** Note a picture's cost, from its start until the graphics had finished it. */
  observe(cost_ms: number): void {
    this.#cost_ms += WEIGHT * (cost_ms - this.#cost_ms);
    this.#isDear = this.#cost_ms > (this.#isDear ? this.#limits.cheap_ms : this.#limits.dear_ms);
  }
}
