import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { MapThing } from "../lib/aircraft";
import { usePart } from "../store/hooks";
import { partName } from "../store/parts";

/** What is selected, on the maps and in the plans' tables. */
export interface Selection {
  readonly thing: MapThing | null;
  /** Where the thing is a waypoint: all selected rows of its plan, in ascending order. */
  readonly rows: readonly number[];
}

export type SelectionStore = StoreApi<Selection>;

export const SELECTION = partName<SelectionStore>("selection");

export function createSelection(): SelectionStore {
  return createStore<Selection>(() => ({ thing: null, rows: [] }));
}

/** Select this alone; null: nothing. */
export function selectThing(store: SelectionStore, thing: MapThing | null): void {
  store.setState({ thing, rows: thing?.kind === "waypoint" ? [thing.row] : [] });
}

/** Add a waypoint to the selected ones of its plan, or take it away. Other things are selected alone. */
export function toggleThing(store: SelectionStore, thing: MapThing): void {
  const now = store.getState();
  if (thing.kind !== "waypoint" || now.thing?.kind !== "waypoint" || now.thing.plan !== thing.plan) {
    selectThing(store, thing);
    return;
  }
  const rows = now.rows.includes(thing.row)
    ? now.rows.filter((row) => row !== thing.row)
    : [...now.rows, thing.row].sort((one, other) => one - other);
  const last = rows.at(-1);
  store.setState(
    last === undefined
      ? { thing: null, rows }
      : { thing: { ...thing, row: rows.includes(thing.row) ? thing.row : last }, rows },
  );
}

/** Select these waypoints; none: nothing. */
export function selectRows(store: SelectionStore, plan: "flight" | "hil", rows: readonly number[]): void {
  const [first] = rows;
  store.setState(
    first === undefined ? { thing: null, rows: [] } : { thing: { kind: "waypoint", plan, row: first }, rows },
  );
}

/** The selection on the map. */
export function useMapThing(): MapThing | null {
  return useStore(usePart(SELECTION), ({ thing }) => thing);
}
