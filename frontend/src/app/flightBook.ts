import { type ChecklistPart, createChecklist } from "../features/checklist/checklist";
import { eventMessage, groupOf } from "../features/flights/flightEvents";
import { createFlightLog, type FlightLog } from "../features/log/flightLog";
import type { Timers } from "../lib/timers";
import type { StreamEvent } from "../protocol/envelope";
import type { Gateway } from "../requests/asking";
import type { BrowserStorage } from "../store/settings";
import { type WatchedMoment, watching } from "./watching";

/** What is gone through before take-off, and what is written down from then on. */
export function createFlightBook(parts: {
  readonly rest: Gateway;
  readonly timers: Timers;
  readonly tabStorage: BrowserStorage | null;
  readonly seen: WatchedMoment;
}): {
  readonly checklist: ChecklistPart;
  readonly flightLog: FlightLog;
  readonly takeEvent: (event: StreamEvent) => void;
} {
  const { rest, timers, tabStorage, seen } = parts;
  const { checklist, takeChecklistEvent } = createChecklist({
    rest,
    storage: tabStorage,
    sees: watching(seen),
  });
  const { flightLog, takeLogEvent } = createFlightLog({
    rest,
    timers,
    connection: seen.connection,
    tell: (event) => ({ group: groupOf(event), message: eventMessage(event) }),
  });
  return {
    checklist,
    flightLog,
    takeEvent: (event) => {
      takeLogEvent(event);
      takeChecklistEvent(event);
    },
  };
}
