import { readFlightName } from "../lib/flightName";
import { isFlightTopics, isSignals, type Signals } from "../protocol/guards.gen";
import type { Gateway } from "../requests/asking";
import type { Page } from "../store/hooks";
import { partName } from "../store/parts";

/** Recorded signals, `topic.field`, of the flight that a page shows; Unix seconds. */
export interface SignalPast {
  /** Null where the flight or its samples are not known. What the flight does not have is left out. */
  readonly ask: (
    page: Page,
    names: readonly string[],
    from_s: number,
    to_s: number,
  ) => Promise<Signals | null>;
}

export const SIGNAL_PAST = partName<SignalPast>("past of signals");

/** Steps of an answer: more than a plot of half a minute has pixels. */
const POINTS = 1500;
/** A flight's name is its start to the second. */
const NAME_S = 2;

export function createSignalPast(rest: Gateway): SignalPast {
  return {
    ask: async (page, names, from_s, to_s) => {
      const { status } = page.connection.getState();
      const recorded = status?.recording.active === true ? status.recording.file : null;
      const flight = readFlightName(page.past ?? recorded ?? "");
      if (flight === null) {
        return null;
      }
      const path = `/api/v1/flights/${flight.id}`;
      const has = await rest.ask("GET", `${path}/topics`, isFlightTopics);
      const recordedNames = new Set(
        (has.ok ? has.value.topics : []).flatMap((topic) =>
          topic.fields.map(({ name }) => `${topic.name}.${name}`),
        ),
      );
      const there = names.filter((name) => recordedNames.has(name));
      if (there.length === 0) {
        return null;
      }
      const first_s = Math.max(0, from_s - flight.started_s - NAME_S);
      const query = new URLSearchParams({
        names: there.join(","),
        from_s: first_s.toFixed(3),
        to_s: Math.max(first_s, to_s - flight.started_s + NAME_S).toFixed(3),
        points: String(POINTS),
      });
      const answer = await rest.ask("GET", `${path}/signals?${query.toString()}`, isSignals);
      return answer.ok ? answer.value : null;
    },
  };
}
