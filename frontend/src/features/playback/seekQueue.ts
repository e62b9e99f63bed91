import { Repeating } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";

/** A dragged handle asks at most so often. */
const SPACING_MS = 50;
/** Without an answer in this time, the next one is sent. */
const PATIENCE_MS = 1000;

/** Sends the moments that somebody drags to: at most one is under way, and of those that wait only the newest counts. */
export class SeekQueue {
  readonly #send: (at_s: number) => void;
  readonly #timers: Timers;
  #isUnderWay = false;
  #sent_ms = Number.NEGATIVE_INFINITY;
  #waiting_s: number | null = null;
  #isHurried = false;
  readonly #spacing: Repeating;
  readonly #patience: Repeating;

  constructor(send: (at_s: number) => void, timers: Timers) {
    this.#send = send;
    this.#timers = timers;
    this.#spacing = new Repeating(timers, () => this.#next(), SPACING_MS);
    this.#patience = new Repeating(timers, () => this.answered(), PATIENCE_MS);
  }

  /** A moment was asked for and is not shown yet. */
  get isBusy(): boolean {
    return this.#isUnderWay || this.#waiting_s !== null;
  }

  ask(at_s: number): void {
    this.#waiting_s = at_s;
    this.#spacing.run();
  }

  /** The hand has let go: what was asked for last goes as soon as nothing is under way. */
  hurry(): void {
    this.#isHurried = this.#waiting_s !== null;
    this.#spacing.run();
  }

  /** The gateway answered the one that is under way. */
  answered(): null {
    if (this.#isUnderWay) {
      this.#isUnderWay = false;
      this.#patience.cancel();
      this.#spacing.run();
    }
    return null;
  }

  /** Forget what is under way and what waits. */
  clear(): void {
    this.#spacing.cancel();
    this.#patience.cancel();
    this.#isUnderWay = false;
    this.#isHurried = false;
    this.#waiting_s = null;
  }

  /** In how many milliseconds the one that waits may go; null: none waits, or it went. */
  #next(): number | null {
    const at_s = this.#waiting_s;
    if (at_s === null || this.#isUnderWay) {
      return null;
    }
    const wait_ms = this.#isHurried ? 0 : this.#sent_ms + SPACING_MS - this.#timers.now_ms();
    if (wait_ms > 0) {
      return wait_ms;
    }
    this.#waiting_s = null;
    this.#isHurried = false;
    this.#isUnderWay = true;
    this.#sent_ms = this.#timers.now_ms();
    this.#patience.arm(PATIENCE_MS);
    this.#send(at_s);
    return null;
  }
}
