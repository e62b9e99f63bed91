import type { Timers } from "./timers";

/** In how many milliseconds the next turn is due; null: when it is armed again. */
type Next = number | null;

/**
 * A chain of timers that arms itself again. What a turn throws, or its promise, is counted and reported, once for each
 * run of turns that fail; the next turn comes in `afterFailure_ms` all the same. Nothing else arms a timer from its own
 * callback.
 */
export class Repeating {
  readonly #timers: Timers;
  readonly #turn: () => Next | Promise<Next>;
  readonly #afterFailure_ms: Next;
  #cancelTimer: (() => void) | null = null;
  /** Counts turns and cancels: a turn that has been overtaken arms nothing. */
  #round = 0;
  #isFailing = false;
  #failures = 0;

  constructor(timers: Timers, turn: () => Next | Promise<Next>, afterFailure_ms: Next) {
    this.#timers = timers;
    this.#turn = turn;
    this.#afterFailure_ms = afterFailure_ms;
  }

  /** Number of turns that failed. */
  get failures(): number {
    return this.#failures;
  }

  /** Whether a turn is due. */
  get isArmed(): boolean {
    return this.#cancelTimer !== null;
  }

  /** Have a turn in so many milliseconds; nothing if one is due already. */
  arm(in_ms: number): void {
    this.#cancelTimer ??= this.#timers.after(in_ms, () => {
      this.#cancelTimer = null;
      this.run();
    });
  }

  /** Have a turn now, instead of the one that was due. */
  run(): void {
    this.cancel();
    const round = this.#round;
    try {
      const next = this.#turn();
      if (next instanceof Promise) {
        next.then(
          (in_ms) => this.#succeeded(round, in_ms),
          (error: unknown) => this.#failed(round, error),
        );
      } else {
        this.#succeeded(round, next);
      }
    } catch (error) {
      this.#failed(round, error);
    }
  }

  /** No turn is due until it is armed or run again. */
  cancel(): void {
    this.#round += 1;
    this.#cancelTimer?.();
    this.#cancelTimer = null;
  }

  #succeeded(round: number, in_ms: Next): void {
    this.#isFailing = false;
    this.#continue(round, in_ms);
  }

  #failed(round: number, error: unknown): void {
    this.#failures += 1;
    const wasFailing = this.#isFailing;
    this.#isFailing = true;
    this.#continue(round, this.#afterFailure_ms);
    if (!wasFailing) {
      (this.#timers.report ?? reportError)(error);
    }
  }

  #continue(round: number, in_ms: Next): void {
    if (round === this.#round && in_ms !== null) {
      this.arm(in_ms);
    }
  }
}

/** Reads something of the gateway at once and every so often, while somebody watches it. */
export class Polling {
  readonly #repeating: Repeating;
  #watchers = 0;

  /** `read` may return false: it is not read again before it is asked for. */
  constructor(timers: Timers, every_ms: number, read: () => Promise<unknown>) {
    const next = (): Next => (this.#watchers > 0 ? every_ms : null);
    this.#repeating = new Repeating(timers, async () => ((await read()) === false ? null : next()), every_ms);
  }

  get isWatched(): boolean {
    return this.#watchers > 0;
  }

  /** Read it now, watched or not. */
  readonly read = (): void => this.#repeating.run();

  /** Read it now, if nobody watches yet, and again until the returned function is called. */
  readonly watch = (): (() => void) => {
    this.#watchers += 1;
    if (this.#watchers === 1) {
      this.read();
    }
    let isOver = false;
    return () => {
      if (!isOver) {
        isOver = true;
        this.#watchers -= 1;
        if (this.#watchers === 0) {
          this.#repeating.cancel();
        }
      }
    };
  };
}
