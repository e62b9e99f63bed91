import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import { AIRCRAFT, type Aircraft } from "../../../lib/aircraft";
import { TrackPoints } from "../../../lib/track/trackPoints";
import type { TrackPiece } from "../../../protocol/track";
import { usePart } from "../../../store/hooks";
import type { Message } from "../../../store/messages";
import { partName } from "../../../store/parts";

/** A summary of one track; its points are in `TrackLog.points`. */
export interface TrackSummary {
  readonly count: number;
  /** Unix seconds of the first and the newest point. */
  readonly first_s: number | null;
  readonly last_s: number | null;
  /** Points at the gateway; more than `count` while they are being loaded. */
  readonly total: number;
}

export interface Tracks {
  readonly summary: Readonly<Record<Aircraft, TrackSummary>>;
  /** Whether a track that was cleared, or is of an earlier flight, can be restored; null until known. */
  readonly canRestore: boolean | null;
  /** Why the newest request failed; null if it did not. */
  readonly failure: Message | null;
  /** Number of malformed answers, and of points that lie nowhere on earth. */
  readonly malformed: number;
}

export type TrackStore = StoreApi<Tracks>;

/** The flown tracks as far as this page has loaded them. */
export interface TrackLog {
  readonly store: TrackStore;
  readonly points: Readonly<Record<Aircraft, TrackPoints>>;
  /** Loads missing points once a second until the returned function is called; any number may watch. */
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

/** Points added without a pause: a millisecond or two of work, so that a page which has to catch up does not freeze. */
const SLICE = 10_000;

/** One track, assembled from the gateway's pieces. */
export class GrowingTrack {
  readonly points = new TrackPoints();
  #epoch: number | null = null;
  #next = 0;
  #total = 0;
  #malformed = 0;

  /** The version of the known track and the next index: what the next request sends. */
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
   * Adds a piece in slices: each step of the sequence is one slice, and other work runs between them. A new version
   * of the track replaces all points; a piece that does not follow the known points is dropped and the track loaded
   * from the start.
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

  /** Load again from the start; the drawn points stay until the answer comes. */
  forget(): void {
    this.#epoch = null;
    this.#next = 0;
  }
}

export function growingTracks(): Readonly<Record<Aircraft, GrowingTrack>> {
  return { flight: new GrowingTrack(), hil: new GrowingTrack() };
}

/** Publish the tracks' summaries, unless nothing has changed. */
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

export function useTracks<T>(select: (tracks: Tracks) => T): T {
  return useStore(usePart(TRACK_LOG).store, select);
}
