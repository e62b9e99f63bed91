import { useStore } from "zustand";
import type { MapThing } from "../../lib/mapThing";
import { usePart } from "../../store/hooks";
import { MAP_SELECTION } from "./mapSelection";

/** The selection on the map. */
export function useMapThing(): MapThing | null {
  return useStore(usePart(MAP_SELECTION), ({ thing }) => thing);
}
