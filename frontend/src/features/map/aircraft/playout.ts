/** After such a gap there is no interpolation: the next sample is shown at once. */
const LAPSE_S = 2.5;
/** Greatest delay, however rarely samples come. */
const LONGEST_PERIOD_S = 1.5;
const WEIGHT = 0.15;
/** Room for the samples that come in one batch while the page is busy. */
const KEPT = 32;

interface TimedSample<T> {
  readonly t_s: number;
  readonly value: T;
}

/**
 * Interpolates between the samples of a stream. The picture is behind by one sample period and the usual delay of
 * arrival, so that the next sample is there before it is needed: smooth at any rate.
 */
export class Playout<T> {
  readonly #between: (from: T, to: T, share: number) => T;
  #samples: TimedSample<T>[] = [];
  #period_s: number | null = null;
  #way_s: number | null = null;

  /** `between`: the interpolated value at a share (0..1). */
  constructor(between: (from: T, to: T, share: number) => T) {
    this.#between = between;
  }

  /** A sample measured at `t_s`, received at `now_s` of the same clock. A repeated one is ignored. */
  push(t_s: number, value: T, now_s: number): void {
    const newest = this.#samples.at(-1);
    if (newest !== undefined && t_s <= newest.t_s) {
      if (t_s > newest.t_s - LAPSE_S) {
        return;
      }
      // The clock went back: this is another stream.
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

  /** The value to show at `now_s` and its time; null before the first sample. */
  at(now_s: number): TimedSample<T> | null {
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
