import { useStore } from "zustand";
import { usePart } from "../../../store/hooks";
import type { MapLayers } from "./layerList";
import { MAP_LAYERS } from "./layerList";

export function useMapLayers<T>(select: (layers: MapLayers) => T): T {
  return useStore(usePart(MAP_LAYERS).store, select);
}
