import { createStore, type StoreApi } from "zustand/vanilla";
import type { MapThing } from "../../lib/mapThing";
import { partName } from "../../store/parts";

/** The selection on the map: its values are shown in a card. */
export type MapSelectionStore = StoreApi<{ readonly thing: MapThing | null }>;

export const MAP_SELECTION = partName<MapSelectionStore>("map selection");

export function createMapSelection(): MapSelectionStore {
  return createStore(() => ({ thing: null }));
}

export function selectThing(store: MapSelectionStore, thing: MapThing | null): void {
  store.setState({ thing });
}
