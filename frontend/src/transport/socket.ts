import { Repeating } from "../lib/repeating";
import type { Timers } from "../lib/timers";
import type { StreamMessage } from "../protocol/envelope";
import { batchNumber, parseMessage } from "../protocol/envelope";

/** One connection, as a browser's WebSocket is. */
export interface Wire {
  readonly send: (text: string) => void;
  /** Bytes that were sent and have not left this computer's browser. */
  readonly unsent_bytes: () => number;
  readonly close: () => void;
}

/** Who hears of a connection: what came, and that it is over. */
export interface WireListener {
  readonly onMessage: (data: unknown) => void;
  readonly onClose: () => void;
}

/**
 * `connecting`: dialling. `open`: messages come. `silent`: the line stands and nothing came for a second.
 * `waiting`: it broke; the next try is in `retry_ms`.
 */
export type SocketState =
  | { readonly kind: "connecting" }
  | { readonly kind: "open" }
  | { readonly kind: "silent" }
  | { readonly kind: "waiting"; readonly retry_ms: number };

export interface SocketOptions {
  readonly dial: (listener: WireListener) => Wire;
  readonly timers: Timers;
  /** Unix milliseconds: unlike the timers' clock it goes on while the computer sleeps. */
  readonly wall_ms: () => number;
  readonly onMessage: (message: StreamMessage, now_ms: number) => void;
  readonly onState: (state: SocketState) => void;
  /** A message that is not as agreed: dropped here, counted by the receiver of this call. */
  readonly onMalformed: () => void;
  /** Hears of exceptions of `dial` and `onState`, which do not keep the line from being dialled again. */
  readonly report: (error: unknown) => void;
}

/** The gateway sends its status twice a second, so a second of nothing means that something is wrong. */
const SILENT_AFTER_MS = 1000;
/** A line that stays silent so long is given up and dialled again. */
const GIVE_UP_AFTER_MS = 5000;
const CHECK_EVERY_MS = 250;
const LATE_MS = 750;
const FIRST_RETRY_MS = 250;
const LAST_RETRY_MS = 4000;

/** The stream's line: dials, checks and acknowledges what comes, notices silence, and dials again after a loss. */
export class StreamSocket {
  readonly #options: SocketOptions;
  #wire: Wire | null = null;
  #state: SocketState = { kind: "connecting" };
  #heard_ms = 0;
  #heardWall_ms = 0;
  #looked_ms = 0;
  #wasHeldUp = false;
  #failures = 0;
  readonly #looks: Repeating;
  readonly #dials: Repeating;
  #stopped = true;

  constructor(options: SocketOptions) {
    this.#options = options;
    const timers = { ...options.timers, report: options.report };
    this.#looks = new Repeating(timers, () => this.#check(), CHECK_EVERY_MS);
    this.#dials = new Repeating(timers, () => this.#dial(), FIRST_RETRY_MS);
  }

  start(): void {
    if (this.#stopped) {
      this.#stopped = false;
      this.#dials.run();
    }
  }

  stop(): void {
    this.#stopped = true;
    this.#hangUp();
  }

  /** Send what is worth nothing later: where something waits already, or the line is not well, it is left out. */
  offer(text: string): void {
    const wire = this.#wire;
    if (wire !== null && this.#state.kind === "open" && wire.unsent_bytes() === 0) {
      wire.send(text);
    }
  }

  /** Send a request; false if the line is not well, and nothing was sent. */
  ask(text: string): boolean {
    if (this.#wire === null || this.#state.kind !== "open") {
      return false;
    }
    this.#wire.send(text);
    return true;
  }

  #dial(): null {
    this.#become({ kind: "connecting" });
    this.#hear(this.#options.timers.now_ms());
    let wire: Wire | null = null;
    try {
      wire = this.#options.dial({
        // What an old line still has to say must not be taken for the new one's.
        onMessage: (data) => wire !== null && this.#wire === wire && this.#receive(wire, data),
        onClose: () => wire !== null && this.#wire === wire && this.#lost(),
      });
    } catch (error) {
      this.#options.report(error);
      this.#lost();
      return null;
    }
    this.#wire = wire;
    this.#looked_ms = this.#heard_ms;
    this.#looks.arm(CHECK_EVERY_MS);
    return null;
  }

  #receive(wire: Wire, data: unknown): void {
    const now_ms = this.#options.timers.now_ms();
    const text = typeof data === "string" ? data : "";
    const message = parseMessage(text);
    if (message === null) {
      acknowledge(wire, batchNumber(text));
      this.#options.onMalformed();
      return;
    }
    this.#hear(now_ms);
    this.#failures = 0;
    if (message.type === "opening") {
      return;
    }
    if (this.#state.kind !== "open") {
      this.#become({ kind: "open" });
    }
    try {
      this.#options.onMessage(message, now_ms);
    } finally {
      acknowledge(wire, message.type === "batch" ? message.seq : null);
    }
  }

  /** Look at the silence every quarter of a second, for as long as the line stands. */
  #check(): number | null {
    if (this.#isHeldUp() || this.#look()) {
      return CHECK_EVERY_MS;
    }
    this.#lost();
    return null;
  }

  /**
   * Whether this look comes much too late: the page itself was busy, and what came meanwhile is still to be read. Never
   * twice in a row, for in a hidden tab every look is late.
   */
  #isHeldUp(): boolean {
    const before_ms = this.#looked_ms;
    this.#looked_ms = this.#options.timers.now_ms();
    this.#wasHeldUp = !this.#wasHeldUp && this.#looked_ms - before_ms > LATE_MS;
    return this.#wasHeldUp;
  }

  #hear(now_ms: number): void {
    this.#heard_ms = now_ms;
    this.#heardWall_ms = this.#options.wall_ms();
  }

  /**
   * Notice silence; false if it has lasted too long. Of a computer that slept the browser may say that its line is open,
   * though the other end gave it up long ago: the silence counts by whichever clock went on.
   */
  #look(): boolean {
    const silence_ms = Math.max(
      this.#options.timers.now_ms() - this.#heard_ms,
      this.#options.wall_ms() - this.#heardWall_ms,
    );
    if (silence_ms >= GIVE_UP_AFTER_MS) {
      return false;
    }
    if (silence_ms >= SILENT_AFTER_MS && this.#state.kind === "open") {
      this.#become({ kind: "silent" });
    }
    return true;
  }

  #lost(): void {
    this.#hangUp();
    if (this.#stopped) {
      return;
    }
    const retry_ms = Math.min(LAST_RETRY_MS, FIRST_RETRY_MS * 2 ** this.#failures);
    this.#failures += 1;
    this.#become({ kind: "waiting", retry_ms });
    this.#dials.arm(retry_ms);
  }

  #hangUp(): void {
    this.#looks.cancel();
    this.#dials.cancel();
    const wire = this.#wire;
    this.#wire = null;
    wire?.close();
  }

  #become(state: SocketState): void {
    this.#state = state;
    try {
      this.#options.onState(state);
    } catch (error) {
      this.#options.report(error);
    }
  }
}

/**
 * Every batch is acknowledged, also one that could not be read or handled: after a few batches without an
 * acknowledgement the gateway sends no more.
 */
function acknowledge(wire: Wire, seq: number | null): void {
  if (seq !== null) {
    wire.send(`{"type":"ack","seq":${seq}}`);
  }
}
