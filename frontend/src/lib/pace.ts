/** Numbers in words change this often: faster than that nobody can read them. */
export const NUMBER_PERIOD_MS = 100;

/** Descriptions for screen readers change this often. */
export const DESCRIPTION_PERIOD_MS = 500;

/**
 * Lets something slow follow something fast: true at most once in a period. Periods are counted from the page's start,
 * so all that is due is due in the same frame, and the browser builds its picture of the texts once for all of them.
 */
export class Pace {
  readonly #period_ms: number;
  #last = Number.NaN;

  constructor(period_ms: number) {
    this.#period_ms = period_ms;
  }

  due(now_ms: number): boolean {
    const period = Math.floor(now_ms / this.#period_ms);
    if (period === this.#last) {
      return false;
    }
    this.#last = period;
    return true;
  }

  /** The next question is answered with yes: after a pause the first value must show at once. */
  reset(): void {
    this.#last = Number.NaN;
  }
}
