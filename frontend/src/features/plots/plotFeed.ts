import { createStore, type StoreApi } from "zustand/vanilla";
import { type FlightTopic, isFlightTopics, isSignals } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { drawnOf, type PlotSeries } from "./drawn";
import { parseSignal } from "./signalNames";

/** What is to be drawn. `shift_s` is where the flight is at zero seconds of the plots. */
export interface PlotRequest {
  readonly flight: string;
  readonly names: readonly string[];
  readonly from_s: number;
  readonly to_s: number;
  readonly points: number;
  readonly shift_s: number;
}

export interface FeedState {
  readonly flight: string | null;
  /** Unix seconds of zero seconds of the plots; null while not known. */
  readonly starts_s: number | null;
  /** What the flight has; null while not known. */
  readonly topics: readonly FlightTopic[] | null;
  readonly signals: ReadonlyMap<string, PlotSeries>;
  /** How far the last answer reaches. */
  readonly to_s: number;
  readonly isLoading: boolean;
  /** Why the last question was not answered; null if it was. */
  readonly failure: Message | null;
}

export interface PlotFeed {
  readonly store: StoreApi<FeedState>;
  /** Ask for this, unless it is known already or `anew`. Null: nothing is wanted, and all is forgotten. */
  readonly want: (wanted: PlotRequest | null, anew?: boolean) => void;
  /** Ask again after a failure. */
  readonly retry: () => void;
}

const NOTHING: FeedState = {
  flight: null,
  starts_s: null,
  topics: null,
  signals: new Map(),
  to_s: 0,
  isLoading: false,
  failure: null,
};

/** Whether all that a signal is made of is in these topics. */
export function isThere(topics: readonly FlightTopic[], name: string): boolean {
  return (parseSignal(name)?.operands ?? []).every((operand) => {
    const [topic, field] = operand.split(".");
    return topics.some(
      (one) => one.name === topic && one.fields.some((has) => has.name === field && has.kind !== "text"),
    );
  });
}

/** Asks for the signals of one flight. At most one question is under way; of those that wait only the newest counts. */
export function createPlotFeed(rest: Gateway): PlotFeed {
  const store = createStore<FeedState>(() => NOTHING);
  let wanted: PlotRequest | null = null;
  let asked = "";
  let isBusy = false;
  let isAnew = false;

  async function ask(): Promise<void> {
    if (isBusy) {
      return;
    }
    isBusy = true;
    for (let next = wanted; next !== null && keyOf(next) !== asked; next = wanted) {
      asked = keyOf(next);
      await answer(next);
    }
    isBusy = false;
  }

  async function answer(question: PlotRequest): Promise<void> {
    const { flight, shift_s } = question;
    store.setState({ isLoading: true });
    const failed = (message: Message): void => {
      if (wanted?.flight === flight) {
        store.setState({ isLoading: false, failure: message });
      }
    };
    // What is known is not waited for: the question leaves before the plots draw what they have.
    const known = knownTopics(question);
    const topics = known === null ? await topicsFor(question) : ({ ok: true, value: known } as const);
    if (!topics.ok) {
      failed(failureMessage(topics.problem));
      return;
    }
    const names = question.names.filter((name) => isThere(topics.value, name));
    if (wanted?.flight !== flight) {
      return;
    }
    if (names.length === 0) {
      store.setState({ topics: topics.value, signals: new Map(), isLoading: false, failure: null });
      return;
    }
    const found = await rest.ask("GET", pathOf(question, names), isSignals);
    if (wanted?.flight !== flight) {
      return;
    }
    if (!found.ok) {
      failed(failureMessage(found.problem));
      return;
    }
    store.setState({
      topics: topics.value,
      starts_s: found.value.starts_s + shift_s,
      to_s: found.value.to_s - shift_s,
      signals: new Map(found.value.signals.map((signal) => [signal.name, drawnOf(signal, shift_s)])),
      isLoading: false,
      failure: null,
    });
  }

  /** What the flight has; null if it must be asked: anew when something is missing, for a flight under way gets more. */
  function knownTopics({ names }: PlotRequest): readonly FlightTopic[] | null {
    const { topics } = store.getState();
    const isNews = isAnew;
    isAnew = false;
    return topics !== null && (!isNews || names.every((name) => isThere(topics, name))) ? topics : null;
  }

  async function topicsFor({ flight }: PlotRequest) {
    const answer = await rest.ask("GET", `/api/v1/flights/${flight}/topics`, isFlightTopics);
    return answer.ok ? ({ ok: true, value: answer.value.topics } as const) : answer;
  }

  function want(next: PlotRequest | null, anew = false): void {
    if (next?.flight !== wanted?.flight) {
      store.setState({ ...NOTHING, flight: next?.flight ?? null });
      asked = "";
    }
    wanted = next;
    if (anew) {
      isAnew = true;
      asked = "";
    }
    void ask();
  }

  return {
    store,
    want,
    retry: () => {
      asked = "";
      void ask();
    },
  };
}

function keyOf({ flight, names, from_s, to_s, points, shift_s }: PlotRequest): string {
  return [flight, from_s, to_s, points, shift_s, ...names].join(" ");
}

function pathOf({ flight, from_s, to_s, points, shift_s }: PlotRequest, names: readonly string[]): string {
  const first_s = Math.max(0, from_s + shift_s);
  const query = new URLSearchParams({
    names: names.join(","),
    from_s: first_s.toFixed(3),
    to_s: Math.max(first_s, to_s + shift_s).toFixed(3),
    points: String(points),
  });
  return `/api/v1/flights/${flight}/signals?${query.toString()}`;
}
