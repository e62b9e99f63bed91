import { createStore, type StoreApi } from "zustand/vanilla";
import { Polling } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import {
  type FlightEvent,
  type FlightOverview,
  isFlightEvents,
  isFlightOverview,
} from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import type { PlaybackStore } from "./playbackState";

/** What is known of the flight in the time bar: the one that is shown, or the one that is being recorded. */
export interface FlightFactsState {
  readonly flight: string | null;
  readonly overview: FlightOverview | null;
  /** Oldest first. */
  readonly events: readonly FlightEvent[];
  /** How far the recording went when it was read last, seconds since its start, and when that was by the page's clock. */
  readonly edge_s: number;
  readonly read_ms: number | null;
}

export type FlightFactsStore = StoreApi<FlightFactsState>;

export interface FlightFacts {
  readonly store: FlightFactsStore;
  /** Reads again while somebody looks, until the returned function is called. */
  readonly watch: () => () => void;
  readonly refresh: () => void;
}

const NOTHING: FlightFactsState = { flight: null, overview: null, events: [], edge_s: 0, read_ms: null };
/** A flight that is being recorded grows. */
const EVERY_MS = 10_000;
/** The edge of a finished flight is told by its replay and by its overview, which may differ by a little. */
const GROWN_S = 1;
/** Points of the altitude: about as many as the bar has pixels. */
const POINTS = 1000;
const CURRENT = "current";

interface Parts {
  readonly rest: Gateway;
  readonly timers: Timers;
  readonly playback: PlaybackStore;
  /** Whether a flight is being recorded: without one there is nothing to ask about in the present. */
  readonly isRecording: () => boolean;
}

export function createFlightFacts({ rest, timers, playback, isRecording }: Parts): FlightFacts {
  const store = createStore<FlightFactsState>(() => NOTHING);
  let asked = 0;
  /** What is known is read, even if it cannot have grown. */
  let isForced = true;

  /** The flight that is shown, or that is being recorded; null: none. */
  function subject(): string | null {
    return playback.getState().flight ?? (isRecording() ? CURRENT : null);
  }

  async function readAll(): Promise<boolean> {
    asked += 1;
    const mine = asked;
    const flight = subject();
    if (flight === null) {
      store.setState(NOTHING);
      return false;
    }
    const [overview, events] = await Promise.all([
      rest.ask("GET", `/api/v1/flights/${flight}/overview?points=${POINTS}`, isFlightOverview),
      rest.ask("GET", `/api/v1/flights/${flight}/events`, isFlightEvents),
    ]);
    if (mine !== asked) {
      return false;
    }
    store.setState({
      flight,
      overview: overview.ok ? overview.value : null,
      events: events.ok ? events.value.events : [],
      edge_s: overview.ok ? overview.value.duration_s : 0,
      read_ms: overview.ok ? timers.now_ms() : null,
    });
    return true;
  }

  /** A finished flight is not read again: it takes both processors' time from the moments that somebody looks for. */
  async function readGrown(): Promise<boolean> {
    const { flight, edge_s } = playback.getState();
    const known = store.getState();
    const isGrowing = flight === null || flight === CURRENT || edge_s > known.edge_s + GROWN_S;
    const isDue = isForced || isGrowing || known.overview === null;
    isForced = false;
    return isDue ? readAll() : true;
  }
  const polling = new Polling(timers, EVERY_MS, readGrown);

  function read(): void {
    isForced = true;
    polling.read();
  }

  playback.subscribe(({ flight }, before) => {
    if (flight !== before.flight && polling.isWatched) {
      if (before.flight !== CURRENT && !(before.flight === null && flight === CURRENT)) {
        // Another flight: what is known of the last one must not stay under the new one's time.
        store.setState(NOTHING);
      }
      read();
    }
  });

  return {
    store,
    refresh: read,
    watch: () => {
      isForced ||= !polling.isWatched;
      return polling.watch();
    },
  };
}
