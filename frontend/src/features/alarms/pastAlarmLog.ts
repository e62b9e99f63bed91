import type { StoreApi } from "zustand/vanilla";
import { isNumber, isObject, isText } from "../../lib/check";
import type { FlightEvent } from "../../protocol/guards.gen";
import { type AlarmLog, createAlarmLogStore, type PastAlarm } from "./alarmLog";

interface Parts {
  /** The flight's events. */
  readonly facts: {
    readonly store: StoreApi<{ readonly events: readonly FlightEvent[] }>;
  };
  /** The alarms of the present, which alone make a sound. */
  readonly live: AlarmLog;
  /** The moment of the flight that is shown, Unix seconds. */
  readonly wall_s: () => number;
}

/** The alarms of a flight of the past up to the moment that is shown: read only, and silent. */
export function createPastAlarmLog({ facts, live, wall_s }: Parts): AlarmLog {
  const store = createAlarmLogStore();
  const fill = (): void => store.setState({ past: pastAlarmsOf(facts.store.getState().events, wall_s()) });
  return {
    ...live,
    store,
    acknowledge: async () => undefined,
    acknowledgeAll: async () => undefined,
    readPast: async () => fill(),
    readThresholds: async () => undefined,
    setThreshold: async () => undefined,
    wall_s,
  };
}

/** The alarms that had ended by then, newest first. */
export function pastAlarmsOf(events: readonly FlightEvent[], by_s: number): readonly PastAlarm[] {
  return events
    .flatMap(({ kind, name, t_s, until_s, data }): readonly PastAlarm[] =>
      kind === "alarm" && until_s !== null && until_s <= by_s
        ? [
            {
              id: name,
              level: data["level"] === "critical" ? "critical" : "warning",
              text: isText(data["text"]) ? data["text"] : name,
              params: paramsOf(data["params"]),
              since_s: t_s,
              until_s,
              acknowledged: data["acknowledged"] === true,
            },
          ]
        : [],
    )
    .sort((first, second) => second.until_s - first.until_s);
}

function paramsOf(params: unknown): PastAlarm["params"] {
  return isObject(params)
    ? Object.fromEntries(
        Object.entries(params).filter(
          (entry): entry is [string, string | number] => isText(entry[1]) || isNumber(entry[1]),
        ),
      )
    : {};
}
