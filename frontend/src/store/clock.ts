/** How fast an old estimate decays, to follow the drift between the two clocks: 0.5 ms each second. */
const DECAY = 0.0005;

/** The clock of one vehicle's messages: what their times are compared with. */
export interface VehicleClock {
  /** Forget everything: another source, or the same one after a restart. */
  reset(): void;
  /** A message made at `made_s` (Unix seconds) arrived at `local_s` (seconds of this page's steady clock). */
  observe(made_s: number, local_s: number): void;
  /** The vehicle's time now, or null before anything was heard. */
  now_s(local_s: number): number | null;
}

/**
 * Estimates the gateway's clock. Every batch carries the time it was made. The fastest one gives the best offset,
 * because a delay can only make the gateway's clock look late. So a batch that was held up does not change the
 * offset, and its samples count as old as they are.
 */
export class ServerClock implements VehicleClock {
  #offset_s: number | null = null;
  #observed_s = 0;

  /** Forget everything: another gateway, or the same one after a restart. */
  reset(): void {
    this.#offset_s = null;
  }

  /** A message made at `server_s` (Unix seconds) arrived at `local_s` (seconds of this page's steady clock). */
  observe(server_s: number, local_s: number): void {
    const candidate_s = server_s - local_s;
    const given_way_s =
      this.#offset_s === null
        ? candidate_s
        : this.#offset_s - DECAY * Math.max(0, local_s - this.#observed_s);
    this.#offset_s = Math.max(candidate_s, given_way_s);
    this.#observed_s = local_s;
  }

  /** The gateway's time now, or null before anything was heard. */
  now_s(local_s: number): number | null {
    return this.#offset_s === null ? null : local_s + this.#offset_s;
  }
}

/**
 * The clock of a flight that is played back: it stands where the newest message stands, paused or at any speed. So a
 * value has the age that it had at that moment of the flight, and not the age of the viewing.
 */
export class FlightClock implements VehicleClock {
  #now_s: number | null = null;

  reset(): void {
    this.#now_s = null;
  }

  observe(made_s: number): void {
    this.#now_s = made_s;
  }

  now_s(): number | null {
    return this.#now_s;
  }
}
