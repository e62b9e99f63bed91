import { createStore, type StoreApi } from "zustand/vanilla";
import type { MapImport, MapLayer, MapOnline, OnlineChoice } from "../../../protocol/mapLayers";
import type { Asker } from "../../../requests/asking";
import type { Message } from "../../../store/messages";
import { partName } from "../../../store/parts";

/** The map layers as the gateway has them. */
export interface MapLayers {
  /** Where their files lie, on the station's computer; null until the gateway has told. */
  readonly folder: string | null;
  readonly layers: readonly MapLayer[];
  /** Why there is no list. */
  readonly failure: Message | null;
  /** Files on their way, or just over, by their number; a good one goes when its layer is in the list. */
  readonly imports: Readonly<Record<string, MapImport>>;
  /** Layers that were taken out here and can be brought back, the newest first. */
  readonly removed: readonly Pick<MapLayer, "id" | "name">[];
  /** Null until the gateway has told. */
  readonly online: MapOnline | null;
}

export type MapLayerStore = StoreApi<MapLayers>;

/** What a person can ask about map layers; nothing here throws. */
export interface MapLayerActions {
  readonly store: MapLayerStore;
  readonly read: () => Promise<void>;
  /** Send a file of this computer into the station's folder. */
  readonly importFile: (file: File, asker: Asker) => Promise<void>;
  readonly cancelImport: (id: string, asker: Asker) => Promise<void>;
  readonly forgetImport: (id: string) => void;
  readonly remove: (layer: Pick<MapLayer, "id" | "name">, asker: Asker) => Promise<void>;
  readonly chooseOnline: (choice: OnlineChoice, asker: Asker) => Promise<void>;
  readonly clearOnline: (asker: Asker) => Promise<void>;
  readonly restore: (layer: Pick<MapLayer, "id" | "name">, asker: Asker) => Promise<void>;
}

export const MAP_LAYERS = partName<MapLayerActions>("map layers");

export function createMapLayers(): MapLayerStore {
  return createStore<MapLayers>(() => ({
    folder: null,
    layers: [],
    failure: null,
    imports: {},
    removed: [],
    online: null,
  }));
}

/** How far an import is, as the gateway says; one that is done is in the list of layers, and goes from here. */
export function noteImport(store: MapLayerStore, entry: MapImport): void {
  const { [entry.id]: _, ...others } = store.getState().imports;
  store.setState({ imports: entry.state === "done" ? others : { ...others, [entry.id]: entry } });
}

export function forgetImport(store: MapLayerStore, id: string): void {
  const { [id]: _, ...imports } = store.getState().imports;
  store.setState({ imports });
}
