import { createStore, type StoreApi } from "zustand/vanilla";
import type { Position } from "../lib/geodesy";
import { partName } from "./parts";

/** That a field be prepared, said on the map: the window for it opens. */
export interface FieldWish {
  /** Null: nobody wishes it. */
  readonly wish: {
    /** Around this place; null: where the window proposes. */
    readonly centre: Position | null;
  } | null;
}

export type FieldWishStore = StoreApi<FieldWish>;

export const FIELD_WISH = partName<FieldWishStore>("field wish");

export function createFieldWish(): FieldWishStore {
  return createStore<FieldWish>(() => ({ wish: null }));
}
