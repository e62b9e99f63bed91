/** Long enough to average bursts, short enough to follow a change. */
const WINDOW_S = 2;

interface Counts {
  readonly at_s: number;
  readonly counts: Readonly<Record<string, number>>;
}

/** Sample rate of each topic, from the gateway's counts in each status. */
export class StreamRates {
  #seen: Counts[] = [];

  /** The counts at `at_s` of the gateway's clock; returns hertz by topic, over the last seconds. */
  observe(at_s: number, counts: Readonly<Record<string, number>>): Readonly<Record<string, number>> {
    const last = this.#seen.at(-1);
    if (last !== undefined && at_s < last.at_s) {
      this.#seen = []; // another gateway: start again
    }
    this.#seen.push({ at_s, counts });
    while ((this.#seen[1]?.at_s ?? at_s) <= at_s - WINDOW_S) {
      this.#seen.shift();
    }
    const first = this.#seen[0];
    const span_s = first === undefined ? 0 : at_s - first.at_s;
    if (first === undefined || span_s <= 0) {
      return {};
    }
    return Object.fromEntries(
      Object.entries(counts).map(([topic, count]) => [
        topic,
        Math.max(0, count - (first.counts[topic] ?? 0)) / span_s,
      ]),
    );
  }
}
