import { createStore, type StoreApi } from "zustand/vanilla";
import type { Timers } from "../../lib/timers";
import type { StreamEvent } from "../../protocol/envelope";
import { type FlightEvent, isFlightEvents } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import type { ConnectionStore } from "../../store/connection";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";

/** What an event of the flight is about; "page": what this page said itself. */
export const LOG_GROUPS = [
  "page",
  "command",
  "alarm",
  "advice",
  "mode",
  "waypoint",
  "mark",
  "trouble",
] as const;
export type LogGroup = (typeof LOG_GROUPS)[number];

/** An event in words. */
export interface EventMessage {
  readonly group: Exclude<LogGroup, "page">;
  readonly message: Message;
}

/** What was recorded of the flight in progress; null until read, and while nothing is recorded. */
export interface FlightLogState {
  readonly events: readonly FlightEvent[] | null;
  readonly failure: Message | null;
}

export interface FlightLog {
  readonly store: StoreApi<FlightLogState>;
  readonly tell: (event: FlightEvent) => EventMessage;
  /** Read the events now, and again shortly after each new one, until the returned function is called. */
  readonly watch: () => () => void;
}

export const FLIGHT_LOG = partName<FlightLog>("log of the flight");

/** The station needs a moment until what happened is in the recording; a burst of events is read once. */
const AFTER_EVENT_MS = 1500;

export function createFlightLog(parts: {
  readonly rest: Pick<Gateway, "ask">;
  readonly timers: Timers;
  readonly connection: ConnectionStore;
  readonly tell: (event: FlightEvent) => EventMessage;
}): { readonly flightLog: FlightLog; readonly takeLogEvent: (event: StreamEvent) => void } {
  const { rest, timers, connection, tell } = parts;
  const store = createStore<FlightLogState>(() => ({ events: null, failure: null }));
  let watchers = 0;
  let newest = 0;
  let isPlanned = false;

  async function read(): Promise<void> {
    newest += 1;
    const mine = newest;
    if (connection.getState().status?.recording.active !== true) {
      store.setState({ events: null, failure: null });
      return;
    }
    const answer = await rest.ask("GET", "/api/v1/flights/current/events", isFlightEvents);
    if (mine === newest) {
      store.setState(
        answer.ok
          ? { events: answer.value.events, failure: null }
          : { failure: failureMessage(answer.problem) },
      );
    }
  }

  function takeLogEvent(_: StreamEvent): void {
    if (watchers === 0 || isPlanned) {
      return;
    }
    isPlanned = true;
    timers.after(AFTER_EVENT_MS, () => {
      isPlanned = false;
      if (watchers > 0) {
        void read();
      }
    });
  }

  return {
    flightLog: {
      store,
      tell,
      watch: () => {
        watchers += 1;
        void read();
        return () => {
          watchers -= 1;
        };
      },
    },
    takeLogEvent,
  };
}
