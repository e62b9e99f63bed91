import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Position } from "../../../lib/geodesy";
import type { GroundPlace } from "../../../scene/legs/target";
import { usePart } from "../../../store/hooks";
import { partName } from "../../../store/parts";

/** What a press on the map does: picks a thing, adds a waypoint, measures, or puts a corner of an area or of the fence. */
export type Tool = "pick" | "add" | "measure" | "area" | "fence";

/** A spot of the map whose menu is open. */
export interface OpenMenu {
  /** Pixels from the map's upper left corner. */
  readonly x: number;
  readonly y: number;
  readonly place: GroundPlace | null;
  readonly waypoint: { readonly plan: "flight" | "hil"; readonly row: number } | null;
  readonly leg: { readonly plan: "flight" | "hil"; readonly row: number; readonly share: number } | null;
}

export interface MapToolState {
  readonly tool: Tool;
  readonly measured: readonly GroundPlace[];
  /** The corners of the area that a survey covers. */
  readonly area: readonly GroundPlace[];
  readonly menu: OpenMenu | null;
  /** The place that "fly here" asks about. */
  readonly flyTo: Position | null;
  /** What of the waypoint that is flown to somebody wants changed. */
  readonly target: TargetField | null;
}

export type TargetField = "altitude_ft" | "speed_kt";

export type MapToolStore = StoreApi<MapToolState>;

export const MAP_TOOL = partName<MapToolStore>("map tool");

export function createMapTool(): MapToolStore {
  return createStore<MapToolState>(() => ({
    tool: "pick",
    measured: [],
    area: [],
    menu: null,
    flyTo: null,
    target: null,
  }));
}

export function chooseTool(store: MapToolStore, tool: Tool): void {
  store.setState({ tool });
}

export function measureFrom(store: MapToolStore, place: GroundPlace): void {
  store.setState({ tool: "measure", measured: [place] });
}

export function useMapTool<T>(select: (state: MapToolState) => T): T {
  return useStore(usePart(MAP_TOOL), select);
}
