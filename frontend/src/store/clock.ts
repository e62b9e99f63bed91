/** How fast an old estimate gives way, so that drift between the two clocks is followed: 0.5 ms each second. */
const GIVE_WAY = 0.0005;

/**
 * The gateway's clock as seen from here. Every batch carries the time it was made; the one that travelled fastest tells
 * the offset best, because a delay can only make the gateway's clock look late. So a batch that was held up on the way
 * does not move the offset, and the samples in it are as old as they are.
 */
export class ServerClock {
  #offset_s: number | null = null;
  #observed_s = 0;

  /** Forget everything: another gateway, or the same one started again. */
  reset(): void {
    this.#offset_s = null;
  }

  /** A message made at `server_s` (Unix seconds) arrived at `local_s` (seconds of this page's steady clock). */
  observe(server_s: number, local_s: number): void {
    const candidate_s = server_s - local_s;
    const given_way_s =
      this.#offset_s === null
        ? candidate_s
        : this.#offset_s - GIVE_WAY * Math.max(0, local_s - this.#observed_s);
    this.#offset_s = Math.max(candidate_s, given_way_s);
    this.#observed_s = local_s;
  }

  /** The gateway's time now, or null before anything was heard. */
  now_s(local_s: number): number | null {
    return this.#offset_s === null ? null : local_s + this.#offset_s;
  }
}
