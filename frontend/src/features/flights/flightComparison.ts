import { createStore, type StoreApi } from "zustand/vanilla";
import { partName } from "../../store/parts";

/** A view that lays two flights side by side. */
export interface ComparisonView {
  /** The button's words: a key of the catalogue. */
  readonly words: string;
  /** Show the two flights; both ids are of finished recordings. */
  readonly open: (first: string, second: string) => void;
}

/**
 * The views that can compare two flights. app registers each of them here (`register`); without any, nothing is
 * offered for comparison.
 */
export interface FlightComparison {
  readonly views: StoreApi<readonly ComparisonView[]>;
  readonly register: (view: ComparisonView) => void;
}

export const FLIGHT_COMPARISON = partName<FlightComparison>("flight comparison");

export function createFlightComparison(): FlightComparison {
  const views = createStore<readonly ComparisonView[]>(() => []);
  return {
    views,
    register: (view) => views.setState([...views.getState(), view], true),
  };
}
