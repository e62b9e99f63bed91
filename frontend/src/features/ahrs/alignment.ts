import { createStore, type StoreApi } from "zustand/vanilla";
import type { FieldSamples } from "../../lib/fieldSamples";
import type { Asker } from "../../requests/asking";
import { partName } from "../../store/parts";

/** The heading that "AHRS 3D" shows as zero, degrees; null: headings as they are. Each source has its own zero. */
export interface Alignment {
  readonly ahrs: number | null;
  readonly ahrs_test: number | null;
}

export type AttitudeSource = keyof Alignment;

/** What "AHRS 3D" keeps while the page lives, and what it can ask; nothing here throws. */
export interface Ahrs3d {
  readonly alignment: StoreApi<Alignment>;
  /** Readings for the calibration of the magnetometer: another tab does not lose them. */
  readonly samples: FieldSamples;
  /** Put the board into its AHRS test: until it ends nothing else is sent, and no command is heard. */
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
