import { useStore } from "zustand";
import { usePart } from "../../../store/hooks";
import { MAP_TOOL, type MapToolState } from "./mapTool";

export function useMapTool<T>(select: (state: MapToolState) => T): T {
  return useStore(usePart(MAP_TOOL), select);
}
