import { useStore } from "zustand";
import type { MapThing } from "../../lib/mapThing";
import { SELECTION } from "../../missions/selection";
import { usePart } from "../../store/hooks";

/** The selection on the map. */
export function useMapThing(): MapThing | null {
  return useStore(usePart(SELECTION), ({ thing }) => thing);
}
