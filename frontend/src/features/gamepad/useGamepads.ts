import { useStore } from "zustand";
import { usePart } from "../../store/hooks";
import type { Gamepads } from "./gamepadList";
import { GAMEPADS } from "./gamepadList";

/** The gamepads of this browser; their positions are painted, see `GamepadInput.watch`. */
export function useGamepads<T>(select: (gamepads: Gamepads) => T): T {
  return useStore(usePart(GAMEPADS).store, select);
}
