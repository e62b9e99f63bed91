import { createStore, type StoreApi } from "zustand/vanilla";
import type { Asker } from "../../requests/asking";
import { partName } from "../../store/parts";
import type { StickAxis, StickMapping } from "./stickMapping";

/** A gamepad in the list: two of one make differ in their index. */
export interface PadName {
  readonly id: string;
  readonly index: number;
}

export interface Gamepads {
  /** What the browser tells now. */
  readonly pads: readonly PadName[];
  /** The one whose axes are mapped; null where none is there, or the one that flies is gone. */
  readonly selected: PadName | null;
  readonly mapping: StickMapping | null;
  /** The axis that waits to be moved. */
  readonly assigning: StickAxis | null;
}

export type GamepadStore = StoreApi<Gamepads>;

/** Position of each axis now; null where it has none, or no gamepad is there. */
export type AxisPositions = Readonly<Record<StickAxis, number | null>>;

/** The gamepads of this browser, and the way of one of them to the aircraft. */
export interface GamepadInput {
  readonly store: GamepadStore;
  /** Hear the axes' positions fifty times a second until the answer is called. */
  readonly watch: (paint: (positions: AxisPositions) => void) => () => void;
  readonly select: (pad: PadName) => void;
  readonly change: (axis: StickAxis, change: Partial<StickMapping[StickAxis]>) => void;
  /** Wait for an axis to be moved, and make it this one; null: do not wait any longer. */
  readonly assign: (axis: StickAxis | null) => void;
  /** Where the stick stands now, it is let go. */
  readonly centre: () => void;
  readonly reset: () => void;
  /** Fly with the selected gamepad, or with the simulator's joystick. */
  readonly fly: (asker: Asker) => Promise<void>;
  readonly flySimulator: (asker: Asker) => Promise<void>;
}

export const GAMEPADS = partName<GamepadInput>("gamepads");

export function createGamepads(): GamepadStore {
  return createStore<Gamepads>(() => ({ pads: [], selected: null, mapping: null, assigning: null }));
}
