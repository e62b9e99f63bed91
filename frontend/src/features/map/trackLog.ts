import { createStore, type StoreApi } from "zustand/vanilla";
import { AIRCRAFT, type Aircraft } from "../../lib/aircraft";
import { TrackPoints } from "../../lib/track/trackPoints";
import type { TrackPiece } from "../../protocol/track";
import type { Message } from "../../store/messages";
import { partName } from "../../store/parts";

/** What is told of one track; its points are in `TrackLog.points`. */
export interface TrackSummary {
  readonly count: number;
  /** Unix seconds of the first and the newest point. */
  readonly first_s: number | null;
  readonly last_s: number | null;
  /** As many points the gateway has; more than `count` while they come. */
  readonly total: number;
}

export interface Tracks {
  readonly summary: Readonly<Record<Aircraft, TrackSummary>>;
  /** A track that was cleared can be brought back; null while nobody has told. */
  readonly canRestore: boolean | null;
  /** Why the newest question found no answer. */
  readonly failure: Message | null;
  /** Answers that were not as agreed, and points that lie nowhere on earth. */
  readonly malformed: number;
}

export type TrackStore = StoreApi<Tracks>;

/** The flown tracks as far as this page knows them. */
export interface TrackLog {
  readonly store: TrackStore;
  readonly points: Readonly<Record<Aircraft, TrackPoints>>;
  /** Asks for what is missing once a second until the returned function is called; any number may watch. */
  readonly watch: () => () => void;
}

export const TRACK_LOG = partName<TrackLog>("track log");

const NONE: TrackSummary = { count: 0, first_s: null, last_s: null, total: 0 };

export function createTracks(): TrackStore {
  return createStore<Tracks>(() => ({
    summary: { flight: NONE, hil: NONE },
    canRestore: null,
    failure: null,
    malformed: 0,
  }));
}

/** A page that stood still for a while takes this many points at once, a millisecond or two of work. */
const SLICE = 10_000;

/** One track, which is put together from the gateway's pieces. */
export class GrowingTrack {
  readonly points = new TrackPoints();
  #epoch: number | null = null;
  #next = 0;
  #total = 0;
  #malformed = 0;

  /** Which track is known, and how much of it; what the next question says. */
  get known(): { readonly epoch: number | null; readonly next: number } {
    return { epoch: this.#epoch, next: this.#next };
  }

  get malformed(): number {
    return this.#malformed;
  }

  get summary(): TrackSummary {
    const { count, first_s, last_s } = this.points;
    return { count, first_s, last_s, total: this.#total };
  }

  /**
   * Takes a piece in slices: each step of the returned sequence is one, and others come between. Of a track that has
   * begun anew nothing stays; a piece that does not follow what is known is left out, and the next is from the start.
   */
  *take(piece: TrackPiece): Generator<void, void, void> {
    if (piece.epoch !== this.#epoch || piece.first < this.#next || piece.total < this.#next) {
      this.points.clear();
      this.#epoch = piece.epoch;
      this.#next = 0;
    }
    this.#total = piece.total;
    if (piece.first !== this.#next) {
      this.forget();
      return;
    }
    for (let place = 0; place < piece.count; place += 1) {
      const point = piece.at(place);
      if (point === null) {
        this.#malformed += 1;
      } else {
        this.points.add(point);
      }
      this.#next += 1;
      if (place % SLICE === SLICE - 1) {
        yield;
      }
    }
  }

  /** Ask from the start; what is drawn stays until the answer is here. */
  forget(): void {
    this.#epoch = null;
    this.#next = 0;
  }
}

export function growingTracks(): Readonly<Record<Aircraft, GrowingTrack>> {
  return { flight: new GrowingTrack(), hil: new GrowingTrack() };
}

/** What the tracks are now; a state that says the same is no new one. */
export function summarise(store: TrackStore, tracks: Readonly<Record<Aircraft, GrowingTrack>>): void {
  const before = store.getState().summary;
  const now = { flight: tracks.flight.summary, hil: tracks.hil.summary };
  const isSame = AIRCRAFT.every(
    (name) =>
      before[name].count === now[name].count &&
      before[name].total === now[name].total &&
      before[name].last_s === now[name].last_s,
  );
  if (!isSame) {
    store.setState({ summary: now });
  }
}
