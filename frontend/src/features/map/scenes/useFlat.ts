import { createContext, useContext } from "react";
import type { FlatScene } from "../../../scene/flat/FlatScene";
import { useSettings } from "../../../store/hooks";

/** The setting that stores which map is chosen. */
export const KIND_CHOICE = "map.kind";
/** The setting that stores whether the flat map follows the aircraft. */
export const FOLLOW_CHOICE = "map.flat.follow";
export const KINDS = ["3d", "2d"] as const;
type MapKind = (typeof KINDS)[number];

interface Flat {
  /** The flat map replaces the globe, by choice or because the globe cannot be drawn. */
  readonly isShown: boolean;
  /** Null until its canvas exists. */
  readonly scene: FlatScene | null;
}

export const FlatContext = createContext<Flat>({ isShown: false, scene: null });

/** Which of the two maps is shown. */
export function useFlat(): Flat {
  return useContext(FlatContext);
}

/** The chosen map; by default the globe. */
export function useMapKind(): MapKind {
  return useSettings(({ choices }) => (choices[KIND_CHOICE] === "2d" ? "2d" : "3d"));
}
