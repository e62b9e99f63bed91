import { useStore } from "zustand";
import type { Aircraft } from "../../../lib/aircraft";
import { SELECTION } from "../../../missions/selection";
import { usePart } from "../../../store/hooks";

const NONE: readonly number[] = [];

/** The selected waypoints of a plan, in ascending order. */
export function useSelectedRows(plan: Aircraft): readonly number[] {
  return useStore(usePart(SELECTION), ({ thing, rows }) =>
    thing?.kind === "waypoint" && thing.plan === plan ? rows : NONE,
  );
}
