import { GuardedCalls } from "../lib/guardedCalls";
import type { Timers } from "../lib/timers";
import { type FlightKnowledge, isFlightKnowledge } from "../protocol/guards.gen";
import type { AskReplay } from "./streamQuestions";

/** What was known of the board at the moment of a flight that is shown: its gains and plans. */
export interface KnownAt {
  /** Called with what was known; with null from the moment on when that is no longer true. */
  readonly onKnown: (hear: (known: FlightKnowledge | null) => void) => void;
  /** Another moment is shown: ask what was known then. */
  readonly read: () => Promise<void>;
  readonly stop: () => void;
}

/** What was known at the moment before stays on the screen at most so long, so that a drag does not make it flicker. */
const FORGET_MS = 250;

/** While a flight is played, its events say what changes. At each other moment, what was known then is asked for. */
export function createKnownAt(ask: AskReplay, timers: Timers, report: (error: unknown) => void): KnownAt {
  const calls = new GuardedCalls(report);
  const listeners: Array<(known: FlightKnowledge | null) => void> = [];
  let asked = 0;
  let cancel: () => void = () => undefined;

  function tell(known: FlightKnowledge | null): void {
    calls.each(listeners, (hear) => hear(known));
  }

  function drop(): void {
    asked += 1;
    cancel();
  }

  return {
    onKnown: (hear) => listeners.push(hear),
    read: async () => {
      drop();
      const mine = asked;
      cancel = timers.after(FORGET_MS, () => tell(null));
      const answer = await ask("known");
      if (mine === asked) {
        cancel();
        tell(isFlightKnowledge(answer) ? answer : null);
      }
    },
    stop: drop,
  };
}
