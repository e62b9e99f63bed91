import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Datum, MapImport, MapLayer, MapOnline, OnlineChoice } from "../../../protocol/mapLayers";
import type { Asker } from "../../../requests/asking";
import { usePart } from "../../../store/hooks";
import type { Message } from "../../../store/messages";
import { partName } from "../../../store/parts";

/** The map layers as the gateway has them. */
export interface MapLayers {
  /** The folder of the files on the station's computer; null until known. */
  readonly folder: string | null;
  readonly layers: readonly MapLayer[];
  /** Why the list could not be read. */
  readonly failure: Message | null;
  /** Imports running or just finished, by number; a successful one is removed when its layer is listed. */
  readonly imports: Readonly<Record<string, MapImport>>;
  /** Layers removed here that can be restored, newest first. */
  readonly removed: readonly Pick<MapLayer, "id" | "name">[];
  /** Null until read from the gateway. */
  readonly online: MapOnline | null;
}

export type MapLayerStore = StoreApi<MapLayers>;

/** The user's requests about map layers; nothing here throws. */
export interface MapLayerActions {
  readonly store: MapLayerStore;
  readonly read: () => void;
  /** Upload a file of this computer to the station's folder. */
  readonly importFile: (file: File, asker: Asker) => Promise<void>;
  readonly cancelImport: (id: string, asker: Asker) => Promise<void>;
  readonly forgetImport: (id: string) => void;
  readonly remove: (layer: Pick<MapLayer, "id" | "name">, asker: Asker) => Promise<void>;
  /** Say what the heights of a set count from, where the set does not say it. */
  readonly chooseDatum: (layer: Pick<MapLayer, "id" | "name">, datum: Datum, asker: Asker) => Promise<void>;
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

/**
 * Note an import's progress as reported by the gateway; a finished one is in the list of layers and is removed here.
 */
export function noteImport(store: MapLayerStore, entry: MapImport): void {
  const { [entry.id]: _, ...others } = store.getState().imports;
  store.setState({ imports: entry.state === "done" ? others : { ...others, [entry.id]: entry } });
}

export function forgetImport(store: MapLayerStore, id: string): void {
  const { [id]: _, ...imports } = store.getState().imports;
  store.setState({ imports });
}

export function useMapLayers<T>(select: (layers: MapLayers) => T): T {
  return useStore(usePart(MAP_LAYERS).store, select);
}
