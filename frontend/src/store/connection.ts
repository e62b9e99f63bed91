import { createStore, type StoreApi } from "zustand/vanilla";
import type { Status } from "../protocol/status";

/** The page's line to the gateway. `silent`: it stands and nothing came for a second. */
export type LinePhase = "connecting" | "open" | "silent" | "waiting";

export interface Connection {
  readonly phase: LinePhase;
  /** Name that the gateway gave this page; commands carry it. */
  readonly client: string | null;
  /** The newest status, also while the line is down: ask `phase` before believing it. */
  readonly status: Status | null;
  /** Frames of the board that were damaged within the last second. */
  readonly damagedLastSecond: number;
  /** Samples a second of each topic. */
  readonly rates_hz: Readonly<Record<string, number>>;
  /** Messages of the gateway that were not as agreed. */
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
