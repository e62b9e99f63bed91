/** Damaged frames of the last second, from a total count. */
export class DamageRate {
  readonly #seen: Array<{ readonly at_ms: number; readonly count: number }> = [];

  /** The gateway counted `count` in all at `now_ms`; returns how many of them came within the last second. */
  observe(count: number, now_ms: number): number {
    if (count < (this.#seen.at(-1)?.count ?? 0)) {
      this.#seen.length = 0; // a new link counts from zero again
    }
    this.#seen.push({ at_ms: now_ms, count });
    // Keep one entry that is at least a second old: the count of that time.
    while ((this.#seen[1]?.at_ms ?? now_ms) <= now_ms - 1000) {
      this.#seen.shift();
    }
    return count - (this.#seen[0]?.count ?? count);
  }
}
