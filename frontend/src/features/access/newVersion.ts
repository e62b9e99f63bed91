import { createStore, type StoreApi } from "zustand/vanilla";
import { partName } from "../../store/parts";

/** A newer version of the page; `load` null: there is none. */
export type NewVersion = StoreApi<{ readonly load: (() => void) | null }>;

export const NEW_VERSION = partName<NewVersion>("new version");

export function createNewVersion(): NewVersion {
  return createStore<{ readonly load: (() => void) | null }>(() => ({ load: null }));
}
