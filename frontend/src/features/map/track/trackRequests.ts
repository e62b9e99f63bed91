import { AIRCRAFT, type Aircraft } from "../../../lib/aircraft";
import { Polling } from "../../../lib/repeating";
import type { Timers } from "../../../lib/timers";
import { tellTiming } from "../../../lib/timers";
import type { StreamEvent } from "../../../protocol/envelope";
import { isTrackState } from "../../../protocol/guards.gen";
import { readTrackPiece } from "../../../protocol/track";
import type { Gateway } from "../../../requests/asking";
import { failureMessage } from "../../../store/messages";
import {
  createTracks,
  type GrowingTrack,
  growingTracks,
  summarise,
  type TrackLog,
  type TrackStore,
} from "./trackLog";

const PERIOD_MS = 1000;
/** Time for two tracks of four hours over a slow network. */
const PATIENCE_MS = 60_000;
const UNREADABLE = {
  code: "answer_unreadable",
  detail: "The gateway's answer is not as agreed: load the page again.",
  params: {},
};

export interface TrackParts {
  readonly rest: Gateway;
  readonly timers: Timers;
  /** Receives an exception in the page's own code. */
  readonly report: (error: unknown) => void;
}

/** Loads the tracks while somebody watches them, and handles the stream's events about them. */
export function createTrackLog({ rest, timers, report }: TrackParts): {
  readonly trackLog: TrackLog;
  readonly takeTrackEvent: (event: StreamEvent) => void;
} {
  const store = createTracks();
  const tracks = growingTracks();
  const polling = new Polling({ ...timers, report }, PERIOD_MS, askAll);

  async function askAll(): Promise<void> {
    const questions = [...AIRCRAFT.map((name) => () => ask(name, tracks[name])), askState];
    const errors: unknown[] = [];
    for (const question of questions) {
      // The other track does not depend on it.
      await question().catch((error: unknown) => errors.push(error));
    }
    if (errors.length > 0) {
      throw errors[0];
    }
  }

  async function askState(): Promise<void> {
    if (store.getState().canRestore === null) {
      const answer = await rest.ask("GET", "/api/v1/track", isTrackState);
      store.setState({ canRestore: answer.ok ? answer.value.can_restore : null });
    }
  }

  async function ask(name: Aircraft, track: GrowingTrack): Promise<void> {
    const { epoch, next } = track.known;
    const known = epoch === null ? "" : `&epoch=${epoch}&after=${next}`;
    const answer = await rest.bytes(`/api/v1/track/points?source=${name}${known}`, PATIENCE_MS);
    if (!answer.ok) {
      store.setState({ failure: failureMessage(answer.problem) });
      return;
    }
    const piece = readTrackPiece(answer.value);
    if (piece === null) {
      store.setState(({ malformed }) => ({ failure: failureMessage(UNREADABLE), malformed: malformed + 1 }));
      return;
    }
    const before = track.malformed;
    let started_ms = performance.now();
    for (const _ of track.take(piece)) {
      tellTiming("track.take", started_ms);
      summarise(store, tracks);
      await new Promise<void>((done) => timers.after(0, done));
      started_ms = performance.now();
    }
    tellTiming("track.take", started_ms);
    if (store.getState().failure !== null || track.malformed !== before) {
      store.setState(({ malformed }) => ({ failure: null, malformed: malformed + track.malformed - before }));
    }
    summarise(store, tracks);
  }

  return {
    trackLog: {
      store,
      points: { flight: tracks.flight.points, hil: tracks.hil.points },
      watch: polling.watch,
    },
    takeTrackEvent: (message) => takeTrackEvent(store, message),
  };
}

function takeTrackEvent(store: TrackStore, { event, data }: StreamEvent): void {
  if (event === "track") {
    store.setState({ canRestore: data.can_restore });
  }
}
