/**
 * The values of some signals over the last seconds, in rows in preallocated memory. A row holds one value per signal
 * at one time; "no data" is NaN inside, null outside.
 */
export class SignalHistory {
  readonly #capacity: number;
  readonly #times_s: Float64Array;
  readonly #columns: ReadonlyMap<string, Float64Array>;
  #next = 0;
  #count = 0;

  /** Holds `capacity` rows; new ones overwrite the oldest. */
  constructor(keys: readonly string[], capacity: number) {
    this.#capacity = capacity;
    this.#times_s = new Float64Array(capacity);
    this.#columns = new Map(keys.map((key) => [key, new Float64Array(capacity)]));
  }

  /** The newest rows for other signals: kept signals keep their values, new ones have no data. */
  withKeys(keys: readonly string[], capacity: number): SignalHistory {
    const other = new SignalHistory(keys, capacity);
    for (let index = 0; index < this.#count; index += 1) {
      const row = this.#row(index);
      other.append(this.#times_s[row] ?? 0, (key) => this.#columns.get(key)?.[row] ?? null);
    }
    return other;
  }

  /** These rows, in order of time, and then its own from `from_s` on. */
  after(earlier: readonly HistoryRow[], from_s: number): SignalHistory {
    const other = new SignalHistory([...this.#columns.keys()], this.#capacity);
    for (const { time_s, read } of earlier) {
      if (time_s < from_s) {
        other.append(time_s, read);
      }
    }
    for (let index = this.#firstFrom(from_s); index < this.#count; index += 1) {
      const row = this.#row(index);
      other.append(this.#times_s[row] ?? 0, (key) => this.#columns.get(key)?.[row] ?? null);
    }
    return other;
  }

  /** Add a row; `read` returns a signal's value, or null. Times must not decrease. */
  append(time_s: number, read: (key: string) => number | null): void {
    this.#times_s[this.#next] = time_s;
    for (const [key, column] of this.#columns) {
      column[this.#next] = read(key) ?? Number.NaN;
    }
    this.#next = (this.#next + 1) % this.#capacity;
    this.#count = Math.min(this.#count + 1, this.#capacity);
  }

  /** Forget every row. */
  clear(): void {
    this.#next = 0;
    this.#count = 0;
  }

  /** The rows of the last `window_s` before `now_s`: seconds relative to now (zero or less), and each signal's values. */
  window(now_s: number, window_s: number): HistoryWindow {
    const before_s: number[] = [];
    const values = new Map<string, Array<number | null>>([...this.#columns.keys()].map((key) => [key, []]));
    for (let index = this.#firstFrom(now_s - window_s); index < this.#count; index += 1) {
      const row = this.#row(index);
      before_s.push((this.#times_s[row] ?? 0) - now_s);
      for (const [key, column] of this.#columns) {
        const value = column[row] ?? Number.NaN;
        values.get(key)?.push(Number.isNaN(value) ? null : value);
      }
    }
    return { before_s, values };
  }

  /** Index from the oldest row of the first one not older than `time_s`. */
  #firstFrom(time_s: number): number {
    let low = 0;
    let high = this.#count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.#times_s[this.#row(middle)] ?? 0) < time_s) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  #row(index: number): number {
    return (this.#next - this.#count + index + this.#capacity) % this.#capacity;
  }
}

/** `read` returns a signal's value, or null. */
export interface HistoryRow {
  readonly time_s: number;
  readonly read: (key: string) => number | null;
}

export interface HistoryWindow {
  readonly before_s: readonly number[];
  readonly values: ReadonlyMap<string, ReadonlyArray<number | null>>;
}

/** The least and greatest value; null if there is none. */
export function extent(values: ReadonlyArray<number | null>): { min: number; max: number } | null {
  let min = Number.POSITIVE_INFINITY;
  let max = Number.NEGATIVE_INFINITY;
  for (const value of values) {
    if (value !== null) {
      min = Math.min(min, value);
      max = Math.max(max, value);
    }
  }
  return min > max ? null : { min, max };
}
