import { createContext, useContext } from "react";
import { AIRCRAFT, type Aircraft } from "../../../lib/aircraft";
import { useMapThing } from "../../../missions/selection";
import { useSettings } from "../../../store/hooks";
import type { MapPlan } from "./useMapPlan";

/** The plan of a map that shows only one; null: the map shows both. */
export const OpenPlanContext = createContext<Aircraft | null>(null);

/** The plan that is edited on the map: that of the selected waypoint, the chosen one, or the one that exists. */
export function useOpenPlan(flight: MapPlan): Aircraft {
  const only = useContext(OpenPlanContext);
  const thing = useMapThing();
  const chosen = useSettings(({ choices }) =>
    AIRCRAFT.find((aircraft) => aircraft === choices["map.plan.open"]),
  );
  if (only !== null) {
    return only;
  }
  return thing?.kind === "waypoint"
    ? thing.plan
    : (chosen ?? (flight.waypoints.length === 0 ? "hil" : "flight"));
}
