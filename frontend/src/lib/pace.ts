/** Numbers as text change at most this often: faster ones cannot be read. */
export const NUMBER_PERIOD_MS = 100;

/** Descriptions for screen readers change at most this often. */
export const DESCRIPTION_PERIOD_MS = 500;

/**
 * Limits a rate: true at most once per period. Periods are counted from the page's start, so that everything due is
 * due in the same animation frame and the browser lays out all texts once.
 */
export class Pace {
  /** How often something was to be shown at once, by all. */
  static #hurries = 0;
  readonly #period_ms: number;
  #last = Number.NaN;
  #hurried = Pace.#hurries;

  /** Make the next call of each pace return true: what is shown is of another moment, and no text may lag behind. */
  static hurry(): void {
    Pace.#hurries += 1;
  }

  constructor(period_ms: number) {
    this.#period_ms = period_ms;
  }

  due(now_ms: number): boolean {
    const period = Math.floor(now_ms / this.#period_ms);
    if (period === this.#last && this.#hurried === Pace.#hurries) {
      return false;
    }
    this.#last = period;
    this.#hurried = Pace.#hurries;
    return true;
  }

  /** Make the next call return true: after a pause the first value is shown at once. */
  reset(): void {
    this.#last = Number.NaN;
  }
}
