import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { FieldSamples } from "../../lib/fieldSamples";
import type { Asker } from "../../requests/asking";
import { usePart } from "../../store/hooks";
import { partName } from "../../store/parts";

/** The heading that "AHRS 3D" shows as zero, degrees; null: not aligned. Each source has its own. */
export interface Alignment {
  readonly ahrs: number | null;
  readonly ahrs_test: number | null;
}

export type AttitudeSource = keyof Alignment;

/** The state of "AHRS 3D" that outlives its tab, and its requests; nothing here throws. */
export interface Ahrs3d {
  readonly alignment: StoreApi<Alignment>;
  /** Readings for the magnetometer's calibration, kept while another tab is open. */
  readonly samples: FieldSamples;
  /** Start the board's AHRS test: until it ends the board sends nothing else and obeys no other command. */
  readonly startTest: (asker: Asker) => Promise<void>;
  readonly stopTest: (asker: Asker) => Promise<void>;
}

export const AHRS = partName<Ahrs3d>("ahrs3d");

export function createAlignment(): StoreApi<Alignment> {
  return createStore<Alignment>(() => ({ ahrs: null, ahrs_test: null }));
}

export function align(store: StoreApi<Alignment>, source: AttitudeSource, zero_deg: number | null): void {
  store.setState({ [source]: zero_deg });
}

export function useAlignment<T>(select: (alignment: Alignment) => T): T {
  return useStore(usePart(AHRS).alignment, select);
}
