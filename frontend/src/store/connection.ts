import { createStore, type StoreApi } from "zustand/vanilla";
import type { Status } from "../protocol/contract";

/** The page's connection to the gateway. `silent`: connected, but nothing came for a second. */
export type LinePhase = "connecting" | "open" | "silent" | "waiting";

export interface Connection {
  readonly phase: LinePhase;
  /** Name that the gateway gave this page; commands carry it. */
  readonly client: string | null;
  /** The newest status, even while disconnected: check `phase` before using it. */
  readonly status: Status | null;
  /** Frames of the board that were damaged within the last second. */
  readonly damagedLastSecond: number;
  /** Sample rate of each topic. */
  readonly rates_hz: Readonly<Record<string, number>>;
  /** Malformed messages of the gateway. */
  readonly malformed: number;
}

export type ConnectionStore = StoreApi<Connection>;

export function createConnection(): ConnectionStore {
  return createStore<Connection>(() => ({
    phase: "connecting",
    client: null,
    status: null,
    damagedLastSecond: 0,
    rates_hz: {},
    malformed: 0,
  }));
}
