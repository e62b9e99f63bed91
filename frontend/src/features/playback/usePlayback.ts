import { useSyncExternalStore } from "react";
import { useStore } from "zustand";
import { useConnection, usePage, usePart } from "../../store/hooks";
import type { FlightFactsState } from "./flightFacts";
import { PLAYBACK } from "./playbackRequests";
import type { PlaybackState } from "./playbackState";

/** One value of the playback; the component renders again when it changes. */
export function usePlayback<T>(select: (state: PlaybackState) => T): T {
  return useStore(usePart(PLAYBACK).store, select);
}

export function useFlightFacts<T>(select: (state: FlightFactsState) => T): T {
  return useStore(usePart(PLAYBACK).facts.store, select);
}

/** Whether there is a flight that is being recorded, to look back at. */
export function useIsRecording(): boolean {
  return useConnection(({ status, phase }) => phase === "open" && status?.recording.active === true);
}

/**
 * How far the flight in the bar goes, whole seconds: in the present it grows with the time since it was read. Zero
 * while not known.
 */
export function useEdge_s(): number {
  const { pump } = usePage();
  const { store, facts } = usePart(PLAYBACK);
  const read = (): number => {
    const { flight, edge_s, duration_s } = store.getState();
    if (flight !== null) {
      return Math.ceil(Math.max(edge_s, duration_s));
    }
    const known = facts.store.getState();
    return known.read_ms === null
      ? 0
      : Math.floor(known.edge_s + Math.max(0, pump.now_ms - known.read_ms) / 1000);
  };
  return useSyncExternalStore(pump.onTick, read);
}
