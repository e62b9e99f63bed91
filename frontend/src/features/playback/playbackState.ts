import { createStore, type StoreApi } from "zustand/vanilla";
import type { Playback as PlaybackPosition } from "../../protocol/guards.gen";
import type { Message } from "../../store/messages";

/** A stretch of a flight, seconds since its start. */
export type Stretch = readonly [from_s: number, to_s: number];

export const LEAST_RATE = 0.1;
export const MOST_RATE = 100;
/** The speeds that the page offers. */
export const RATES: readonly number[] = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** What is looked at of the past. All times in seconds since the flight's start, `starts_s` in Unix seconds. */
export interface PlaybackState {
  /** The flight that is shown; null: the present is shown. `current` until the gateway has told its id. */
  readonly flight: string | null;
  /** Null until the gateway has told it. */
  readonly starts_s: number | null;
  /** The moment that is shown, or was asked for last while the answer is under way. */
  readonly at_s: number;
  /** Changes when somebody goes to another moment; a flight that is played on does not change it. */
  readonly moves: number;
  readonly state: "opening" | PlaybackPosition["state"];
  /** Its line is broken or silent: what is shown does not move. */
  readonly isLost: boolean;
  readonly rate: number;
  readonly loop: Stretch | null;
  readonly duration_s: number;
  /** How far the recording goes so far. */
  readonly edge_s: number;
  /** Why nothing can be shown; null if it can. */
  readonly failure: Message | null;
}

export type PlaybackStore = StoreApi<PlaybackState>;

export const PRESENT: PlaybackState = {
  flight: null,
  starts_s: null,
  at_s: 0,
  moves: 0,
  state: "opening",
  isLost: false,
  rate: 1,
  loop: null,
  duration_s: 0,
  edge_s: 0,
  failure: null,
};

export function createPlaybackStore(): PlaybackStore {
  return createStore<PlaybackState>(() => PRESENT);
}

/** Unix seconds of the moment that is shown; null while not known. */
export function moment_s({ starts_s, at_s }: Pick<PlaybackState, "starts_s" | "at_s">): number | null {
  return starts_s === null ? null : starts_s + at_s;
}

/** The next faster or slower of the offered speeds. */
export function nextRate(rate: number, direction: 1 | -1): number {
  const faster = RATES.find((offered) => offered > rate);
  const slower = [...RATES].reverse().find((offered) => offered < rate);
  return (direction === 1 ? faster : slower) ?? rate;
}
