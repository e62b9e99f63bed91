import { createContext, useContext } from "react";
import type { FlatScene } from "../../../scene/flat/FlatScene";
import { useSettings } from "../../../store/hooks";

/** The name under which is remembered which map is wanted. */
export const KIND_CHOICE = "map.kind";
export const KINDS = ["3d", "2d"] as const;
type MapKind = (typeof KINDS)[number];

interface Flat {
  /** The flat map stands in the globe's place, by choice or for want of it. */
  readonly isShown: boolean;
  /** Null until its canvas is there. */
  readonly scene: FlatScene | null;
}

export const FlatContext = createContext<Flat>({ isShown: false, scene: null });

/** Which of both maps is seen. */
export function useFlat(): Flat {
  return useContext(FlatContext);
}

/** The map that is wanted; the globe, until somebody chooses. */
export function useMapKind(): MapKind {
  return useSettings(({ choices }) => (choices[KIND_CHOICE] === "2d" ? "2d" : "3d"));
}
