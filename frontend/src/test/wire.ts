import type { Timers } from "../lib/timers";
import type { Wire, WireListener } from "../transport/socket";

/** A stream's connection under the test's control. */
export class ManualWire implements Wire {
  readonly sent: string[] = [];
  closed = false;
  /** Bytes that wait in the browser. */
  waiting_bytes = 0;
  readonly #listener: WireListener;

  constructor(listener: WireListener) {
    this.#listener = listener;
  }

  readonly send = (text: string): void => {
    this.sent.push(text);
  };

  readonly unsent_bytes = (): number => this.waiting_bytes;

  readonly close = (): void => {
    this.closed = true;
  };

  /** The gateway sends this message. */
  deliver(message: unknown): void {
    this.#listener.onMessage(typeof message === "string" ? message : JSON.stringify(message));
  }

  /** Something other than text arrives. */
  deliverBytes(bytes: ArrayBuffer): void {
    this.#listener.onMessage(bytes);
  }

  /** The connection breaks. */
  breakOff(): void {
    this.#listener.onClose();
  }
}

/** A clock and timers under the test's control. */
export class ManualTimers implements Timers {
  #now_ms = 0;
  #waiting: Array<{ readonly due_ms: number; readonly run: () => void }> = [];

  readonly now_ms = (): number => this.#now_ms;

  readonly after = (delay_ms: number, run: () => void): (() => void) => {
    const timer = { due_ms: this.#now_ms + delay_ms, run };
    this.#waiting.push(timer);
    return () => {
      this.#waiting = this.#waiting.filter((waiting) => waiting !== timer);
    };
  };

  /** So long the page itself does nothing: what is due meanwhile runs when it goes on. */
  holdUp(duration_ms: number): void {
    this.#now_ms += duration_ms;
  }

  /** Let this time pass; timers run in their order, each at its own time, or now where that is over. */
  pass(duration_ms: number): void {
    const end_ms = this.#now_ms + duration_ms;
    for (;;) {
      const next = this.#waiting
        .filter(({ due_ms }) => due_ms <= end_ms)
        .sort((first, second) => first.due_ms - second.due_ms)[0];
      if (next === undefined) {
        break;
      }
      this.#waiting = this.#waiting.filter((timer) => timer !== next);
      this.#now_ms = Math.max(this.#now_ms, next.due_ms);
      next.run();
    }
    this.#now_ms = end_ms;
  }
}
