import type { Timers } from "../../lib/timers";
import { isDone } from "../../protocol/answers";
import type { Playback as PlaybackPosition } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";
import type { FlightAddress, PlaceInTime } from "./flightAddress";
import { createFlightFacts, type FlightFacts } from "./flightFacts";
import { eventAfter, eventBefore } from "./flightLanes";
import {
  createPlaybackStore,
  LEAST_RATE,
  MOST_RATE,
  type PlaybackStore,
  PRESENT,
  type Stretch,
} from "./playbackState";
import { SeekQueue } from "./seekQueue";

/** The flight that is being recorded. */
export const CURRENT = "current";
/** As long ago as the gateway takes a live mark. */
const LONGEST_AGO_S = 600;

/** The second stream of the page, which brings a flight of the past. */
export interface FlightStream {
  /** False if the line is not well, and nothing was sent. */
  readonly ask: (text: string) => boolean;
  readonly close: () => void;
}

/** Who hears of that stream, beside the stores that it fills. */
export interface FlightListener {
  /** The gateway opened this flight. */
  readonly onOpened: (flight: {
    readonly id: string;
    readonly starts_s: number;
    readonly duration_s: number;
  }) => void;
  readonly onPosition: (position: PlaybackPosition) => void;
  /** Whether the line is well, or broke or is silent. */
  readonly onLine: (isWell: boolean) => void;
}

/** Looks at flights of the past; nothing here throws. Times are seconds since the flight's start. */
export interface Playback {
  readonly store: PlaybackStore;
  /** What the time bar shows of the flight: its altitude, gaps and events. */
  readonly facts: FlightFacts;
  /** Show this moment of a flight on every tab; `current` is the one that is being recorded. */
  readonly openFlight: (flight: string, at_s: number) => void;
  /** Back to the present. */
  readonly now: () => void;
  readonly seek: (at_s: number) => void;
  /** The moment that was sought last is the one: it is asked for without a pause. */
  readonly settle: () => void;
  readonly play: () => void;
  readonly pause: () => void;
  readonly step: (frames: 1 | -1) => void;
  readonly setRate: (rate: number) => void;
  /** Play this stretch again and again; null: no longer. */
  readonly loop: (stretch: Stretch | null) => void;
  /** To the next event, or the one before. */
  readonly jump: (direction: 1 | -1) => void;
  /** Set a mark at the moment that is shown; in the present, `ago_s` before now. Null if it was set, else why not. */
  readonly mark: (text: string, ago_s?: number) => Promise<Message | null>;
  /** The address that shows the same moment to somebody else. */
  readonly address: () => string;
}

export const PLAYBACK = partName<Playback>("playback");

export interface PlaybackParts {
  readonly rest: Gateway;
  readonly timers: Timers;
  readonly address: FlightAddress;
  readonly isRecording: () => boolean;
  /** Opens the second stream. `place` tells where to begin, also after a broken line. */
  readonly open: (place: () => PlaceInTime, listener: FlightListener) => FlightStream;
}

function stretchOf(loop: readonly number[] | null): Stretch | null {
  const [from_s, to_s] = loop ?? [];
  return from_s === undefined || to_s === undefined ? null : [from_s, to_s];
}

/** The start as it is known already, unless it is another one: a difference of two times is a little another each time. */
function startOf(known_s: number | null, starts_s: number): number {
  return known_s !== null && Math.abs(known_s - starts_s) < SAME_S ? known_s : starts_s;
}

/** Two times of a flight nearer than this are the same: floating point. */
const SAME_S = 0.001;

/** A moment nearer than this to an event counts as the event's own. */
const BESIDE_S = 0.25;

export function createPlayback({ rest, timers, address, isRecording, open }: PlaybackParts): Playback {
  const store = createPlaybackStore();
  const facts = createFlightFacts({ rest, timers, playback: store, isRecording });
  let stream: FlightStream | null = null;
  /** What a person wants, which is asked for again when a broken line is back. */
  let wantsToPlay = false;
  /** How often the replay went to another moment, as it said last; null before it said it. */
  let jumps: number | null = null;
  const seeks = new SeekQueue((at_s) => send({ type: "seek", at_s }), timers);

  function send(message: object): void {
    stream?.ask(JSON.stringify(message));
  }

  function opened({ id, starts_s, duration_s }: Parameters<FlightListener["onOpened"]>[0]): void {
    const { loop, rate, edge_s, moves } = store.getState();
    store.setState({
      flight: id,
      starts_s,
      duration_s,
      edge_s: Math.max(edge_s, duration_s),
      failure: null,
      moves: moves + 1,
    });
    seeks.clear();
    jumps = null;
    if (loop !== null) {
      send({ type: "loop", from_s: loop[0], to_s: loop[1] });
    }
    send(wantsToPlay ? { type: "play", rate } : { type: "pause" });
  }

  function heard({ at_s, t_s, state, rate, loop, duration_s, edge_s, jumps: now }: PlaybackPosition): void {
    if (now !== jumps) {
      // Until then the flight may play on where it was.
      jumps = now;
      seeks.answered();
    }
    const isPlaying = state === "playing";
    // A speed that was asked for while the flight stands is sent with the next "play".
    store.setState((before) => ({
      state,
      loop: stretchOf(loop),
      duration_s,
      edge_s,
      starts_s: startOf(before.starts_s, t_s - at_s),
      rate: isPlaying ? rate : before.rate,
      // A step back or a loop goes to another moment too.
      moves: before.moves + (at_s < before.at_s && !seeks.isBusy ? 1 : 0),
      // While a drag is under way the handle stays under the hand.
      ...(seeks.isBusy ? {} : { at_s }),
    }));
    wantsToPlay = isPlaying || (wantsToPlay && state !== "ended" && seeks.isBusy);
    address.keep(placeOf());
  }

  function placeOf(): PlaceInTime | null {
    const { flight, at_s } = store.getState();
    return flight === null ? null : { flight, at_s };
  }

  function close(): void {
    seeks.clear();
    stream?.close();
    stream = null;
  }

  function openFlight(flight: string, at_s: number): void {
    const { edge_s } = facts.store.getState();
    close();
    wantsToPlay = false;
    const from_s = Math.max(0, at_s);
    store.setState({ ...PRESENT, flight, at_s: from_s, edge_s, duration_s: edge_s });
    stream = open(() => placeOf() ?? { flight, at_s: from_s }, {
      onOpened: opened,
      onPosition: heard,
      onLine: (isWell) => store.setState({ isLost: !isWell }),
    });
  }

  function seek(at_s: number): void {
    const { flight, edge_s, duration_s } = store.getState();
    if (flight !== null) {
      const wanted_s = Math.min(Math.max(0, at_s), Math.max(edge_s, duration_s));
      store.setState({ at_s: wanted_s, moves: store.getState().moves + 1 });
      seeks.ask(wanted_s);
    }
  }

  return {
    store,
    facts,
    openFlight,
    seek,
    settle: () => seeks.hurry(),
    now: () => {
      close();
      store.setState(PRESENT);
      address.keep(null);
    },
    play: () => {
      wantsToPlay = true;
      send({ type: "play", rate: store.getState().rate });
    },
    pause: () => {
      wantsToPlay = false;
      send({ type: "pause" });
    },
    step: (frames) => {
      wantsToPlay = false;
      send({ type: "step", frames });
    },
    setRate: (wanted) => {
      const rate = Math.min(MOST_RATE, Math.max(LEAST_RATE, wanted));
      store.setState({ rate });
      if (store.getState().state === "playing") {
        send({ type: "play", rate });
      }
    },
    loop: (stretch) =>
      send(stretch === null ? { type: "loop" } : { type: "loop", from_s: stretch[0], to_s: stretch[1] }),
    jump: (direction) => {
      const { at_s, edge_s } = store.getState();
      const { events } = facts.store.getState();
      const found =
        direction === 1 ? eventAfter(events, at_s + BESIDE_S) : eventBefore(events, at_s - BESIDE_S);
      seek(found?.at_s ?? (direction === 1 ? edge_s : 0));
    },
    mark: async (text, ago_s = 0) => {
      const { flight, at_s } = store.getState();
      const path = `/api/v1/flights/${flight ?? CURRENT}/marks`;
      const when = flight === null ? { ago_s: Math.min(LONGEST_AGO_S, Math.max(0, ago_s)) } : { at_s };
      const answer = await rest.ask("POST", path, isDone, { text, ...when });
      if (!answer.ok) {
        return failureMessage(answer.problem);
      }
      facts.refresh();
      return null;
    },
    address: () => address.of(placeOf()),
  };
}
