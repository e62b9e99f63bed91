/** After so long without a sample the way between is not known: the next one is shown at once. */
const LAPSE_S = 2.5;
/** Behind by no more than this, however rarely samples come. */
const LONGEST_PERIOD_S = 1.5;
const WEIGHT = 0.15;
/** As many as may come in one batch while the page is busy. */
const KEPT = 32;

interface Timed<T> {
  readonly t_s: number;
  readonly value: T;
}

/**
 * Values between the samples of a stream. What is shown is as old as a sample is when it arrives and the time between
 * two of them, so that the next one is there before it is needed: smooth at any rate, and behind by one sample.
 */
export class Playout<T> {
  readonly #between: (from: T, to: T, share: number) => T;
  #samples: Timed<T>[] = [];
  #period_s: number | null = null;
  #way_s: number | null = null;

  /** `between`: the value at a share (0..1) of the way. */
  constructor(between: (from: T, to: T, share: number) => T) {
    this.#between = between;
  }

  /** A sample measured at `t_s`, known here since `now_s` of the same clock. One that was there already is ignored. */
  push(t_s: number, value: T, now_s: number): void {
    const newest = this.#samples.at(-1);
    if (newest !== undefined && t_s <= newest.t_s) {
      if (t_s > newest.t_s - LAPSE_S) {
        return;
      }
      // The clock was set back: another stream.
      this.clear();
    }
    const since_s = newest === undefined ? null : t_s - newest.t_s;
    if (since_s !== null && since_s > LAPSE_S) {
      this.clear();
    } else if (since_s !== null && since_s > 0) {
      this.#period_s =
        this.#period_s === null ? since_s : this.#period_s + WEIGHT * (since_s - this.#period_s);
    }
    const way_s = Math.max(0, now_s - t_s);
    this.#way_s = this.#way_s === null ? way_s : this.#way_s + WEIGHT * (way_s - this.#way_s);
    this.#samples.push({ t_s, value });
    if (this.#samples.length > KEPT) {
      this.#samples.shift();
    }
  }

  clear(): void {
    this.#samples = [];
    this.#period_s = null;
    this.#way_s = null;
  }

  /** What is shown at `now_s`, and when it was so; null before the first sample. */
  at(now_s: number): Timed<T> | null {
    const newest = this.#samples.at(-1);
    if (newest === undefined) {
      return null;
    }
    const behind_s = (this.#way_s ?? 0) + Math.min(LONGEST_PERIOD_S, this.#period_s ?? 0);
    const wanted_s = now_s - behind_s;
    const after = this.#samples.findIndex(({ t_s }) => t_s >= wanted_s);
    const [from, to] = [this.#samples[after - 1], this.#samples[after]];
    if (to === undefined) {
      return newest;
    }
    if (from === undefined) {
      return to;
    }
    const share = (wanted_s - from.t_s) / (to.t_s - from.t_s);
    return { t_s: wanted_s, value: this.#between(from.value, to.value, share) };
  }
}
