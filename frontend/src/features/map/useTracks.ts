import { useStore } from "zustand";
import { usePart } from "../../store/hooks";
import type { Tracks } from "./trackLog";
import { TRACK_LOG } from "./trackLog";

export function useTracks<T>(select: (tracks: Tracks) => T): T {
  return useStore(usePart(TRACK_LOG).store, select);
}
