import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Asker } from "../../requests/asking";
import { usePart } from "../../store/hooks";
import { partName } from "../../store/parts";
import type { Pad, StickAxis, StickMapping } from "./stickMapping";

/** The browser's gamepads, or a test's. */
export interface GamepadReader {
  readonly read: () => readonly Pad[];
  /** A browser stops gamepads and timers of a hidden page: what it reports then is old. */
  readonly isInSight: () => boolean;
  /**
   * Calls `run` when a gamepad is connected, with its index if that is known, or disconnected; the result
   * unsubscribes.
   */
  readonly onChange: (run: (connected?: number) => void) => () => void;
}

/** A gamepad in the list. Two of the same model differ in their index. */
export interface PadName {
  readonly id: string;
  readonly index: number;
}

export interface Gamepads {
  /** The connected gamepads. */
  readonly pads: readonly PadName[];
  /** The gamepad whose axes are mapped; null if there is none, or if the one that flies was disconnected. */
  readonly selected: PadName | null;
  readonly mapping: StickMapping | null;
  /** The axis that is being assigned. */
  readonly assigning: StickAxis | null;
  /** Mapped axes that have not moved since the gamepad was connected: nobody knows where they stand. */
  readonly awaited: readonly StickAxis[];
}

export type GamepadStore = StoreApi<Gamepads>;

/** Position of each axis; null where it is not mapped, or without a gamepad. */
export type AxisPositions = Readonly<Record<StickAxis, number | null>>;

/** The gamepads of this browser, and how one of them flies the aircraft. */
export interface GamepadInput {
  readonly store: GamepadStore;
  /** Calls `paint` with the positions fifty times a second; the result unsubscribes. */
  readonly watch: (paint: (positions: AxisPositions) => void) => () => void;
  readonly select: (pad: PadName) => void;
  readonly change: (axis: StickAxis, change: Partial<StickMapping[StickAxis]>) => void;
  /** Assign the next axis that is moved; null cancels. */
  readonly assign: (axis: StickAxis | null) => void;
  /** Take the stick's present position as its rest. */
  readonly centre: () => void;
  readonly reset: () => void;
  /** The axes stand as the bars show: none is waited for. */
  readonly agree: () => void;
  /** Fly with the selected gamepad, or with the simulator's joystick. */
  readonly fly: (asker: Asker) => Promise<void>;
  readonly flySimulator: (asker: Asker) => Promise<void>;
}

export const GAMEPADS = partName<GamepadInput>("gamepads");

export function createGamepads(): GamepadStore {
  return createStore<Gamepads>(() => ({
    pads: [],
    selected: null,
    mapping: null,
    assigning: null,
    awaited: [],
  }));
}

/** The gamepads of this browser; their positions are painted, see `GamepadInput.watch`. */
export function useGamepads<T>(select: (gamepads: Gamepads) => T): T {
  return useStore(usePart(GAMEPADS).store, select);
}
