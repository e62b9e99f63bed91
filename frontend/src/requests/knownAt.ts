import type { Timers } from "../lib/timers";
import { type FlightKnown, isFlightKnown } from "../protocol/guards.gen";
import type { Gateway } from "./asking";

/** What was known of the board at the moment of a flight that is shown: its gains and plans. */
export interface KnownAt {
  /** Called with what was known; with null from the moment on when that is no longer true. */
  readonly onKnown: (hear: (known: FlightKnown | null) => void) => void;
  /** Ask now. */
  readonly read: () => Promise<void>;
  /** Somebody went to another moment. */
  readonly leave: () => void;
  readonly stop: () => void;
}

interface Parts {
  readonly rest: Gateway;
  readonly timers: Timers;
  /** The moment that is shown; `at_s`: seconds since the flight's start. */
  readonly place: () => { readonly flight: string; readonly at_s: number };
}

/** After a drag has ended so long ago, what was known at that moment is asked for. */
const SETTLED_MS = 150;

/**
 * While a flight is played, its events say what changes. When somebody goes to another moment, what was known at the
 * one that was left is forgotten at once, and asked for again when the handle rests.
 */
export function createKnownAt({ rest, timers, place }: Parts): KnownAt {
  const listeners: Array<(known: FlightKnown | null) => void> = [];
  let asked = 0;
  let cancel: () => void = () => undefined;

  function tell(known: FlightKnown | null): void {
    for (const hear of listeners) {
      hear(known);
    }
  }

  function forget(): void {
    asked += 1;
    cancel();
  }

  async function read(): Promise<void> {
    forget();
    const mine = asked;
    const { flight, at_s } = place();
    const path = `/api/v1/flights/${flight}/known?at_s=${at_s.toFixed(3)}`;
    const answer = await rest.ask("GET", path, isFlightKnown);
    if (mine === asked) {
      tell(answer.ok ? answer.value : null);
    }
  }

  return {
    onKnown: (hear) => listeners.push(hear),
    read,
    leave: () => {
      forget();
      tell(null);
      cancel = timers.after(SETTLED_MS, () => void read());
    },
    stop: forget,
  };
}
