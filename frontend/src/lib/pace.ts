/** Numbers as text change at most this often: faster ones cannot be read. */
export const NUMBER_PERIOD_MS = 100;

/** Descriptions for screen readers change at most this often. */
export const DESCRIPTION_PERIOD_MS = 500;

/**
 * Limits a rate: true at most once per period. Periods are counted from the page's start, so that everything due is
 * due in the same animation frame and the browser lays out all texts once.
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

  /** Make the next call return true: after a pause the first value is shown at once. */
  reset(): void {
    this.#last = Number.NaN;
  }
}
