import { AIRCRAFT, type Aircraft } from "../../../lib/aircraft";
import { readTrackPiece } from "../../../protocol/track";
import type { Gateway } from "../../../requests/asking";
import { failureMessage } from "../../../store/messages";
import { createTracks, growingTracks, summarise, type TrackLog } from "./trackLog";

const PATIENCE_MS = 60_000;
const UNREADABLE = {
  code: "answer_unreadable",
  detail: "The gateway's answer is not as agreed: load the page again.",
  params: {},
};

interface Parts {
  readonly rest: Gateway;
  readonly place: () => { readonly flight: string };
  /** Receives an exception in the page's own code. */
  readonly report: (error: unknown) => void;
}

/** The whole track of a flight of the past, read once when somebody looks at it first. */
export function createPastTrack({ rest, place, report }: Parts): TrackLog {
  const store = createTracks();
  const tracks = growingTracks();
  let isRead = false;

  async function read(name: Aircraft): Promise<boolean> {
    const path = `/api/v1/flights/${place().flight}/track?source=${name}`;
    const answer = await rest.bytes(path, PATIENCE_MS);
    if (!answer.ok) {
      store.setState({ failure: failureMessage(answer.problem) });
      return false;
    }
    const piece = readTrackPiece(answer.value);
    if (piece === null) {
      store.setState({ failure: failureMessage(UNREADABLE) });
      return false;
    }
    for (const _ of tracks[name].take(piece)) {
      summarise(store, tracks);
      await new Promise<void>((done) => setTimeout(done, 0));
    }
    summarise(store, tracks);
    return true;
  }

  async function readAll(): Promise<void> {
    try {
      const found = await Promise.all(AIRCRAFT.map(read));
      isRead = found.every(Boolean);
    } catch (error) {
      report(error);
    }
  }

  return {
    store,
    points: { flight: tracks.flight.points, hil: tracks.hil.points },
    watch: () => {
      if (!isRead) {
        isRead = true;
        void readAll();
      }
      return () => undefined;
    },
  };
}
