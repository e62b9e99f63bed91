import { useCallback, useMemo } from "react";
import type { Aircraft } from "../../../lib/aircraft";
import { SELECTION, selectThing, toggleThing } from "../../../missions/selection";
import { useWaypointEdits } from "../../../missions/useWaypointEdits";
import type { MapTarget } from "../../../scene/legs/target";
import type { PlanListener } from "../../../scene/plan/PlanScene";
import { usePart } from "../../../store/hooks";
import { MAP_TOOL, type OpenMenu, useMapTool } from "../tools/mapTool";
import type { MapPlan } from "./useMapPlan";

type Hands = Pick<PlanListener, "pick" | "tap" | "double" | "menu">;

/** What a press on the map does to the plans, by the chosen tool. */
export function usePlanHands(plans: Readonly<Record<Aircraft, MapPlan>>, open: Aircraft): Hands {
  const selection = usePart(SELECTION);
  const tools = usePart(MAP_TOOL);
  const isAdding = useMapTool(({ tool }) => tool === "add");
  const isPicking = useMapTool(({ tool }) => tool === "pick");
  const flight = useWaypointEdits("flight", plans.flight.waypoints, plans.flight.isFixed);
  const hil = useWaypointEdits("hil", plans.hil.waypoints, plans.hil.isFixed);
  const openMenu = useCallback((target: MapTarget) => tools.setState({ menu: menuAt(target) }), [tools]);
  return useMemo(() => {
    const edits = { flight, hil };
    const insertOn = ({ leg }: MapTarget): boolean => {
      if (leg !== null) edits[leg.plan].insertOnLeg(leg.row, leg.share);
      return leg !== null;
    };
    return {
      pick: (thing, isMore) => (isMore ? toggleThing(selection, thing) : selectThing(selection, thing)),
      tap: (target) => {
        // On a leg of the plan that is edited a waypoint goes into it, not behind the last.
        if (isAdding && !(target.leg?.plan === open && insertOn(target)) && target.place !== null) {
          edits[open].append(target.place);
        }
      },
      double: (target) => {
        if (isPicking) insertOn(target);
      },
      menu: openMenu,
    };
  }, [selection, flight, hil, open, isAdding, isPicking, openMenu]);
}

export function menuAt({ at, place, thing, leg }: MapTarget): OpenMenu {
  return { ...at, place, leg, waypoint: thing?.kind === "waypoint" ? thing : null };
}
