import { AIRCRAFT, type Aircraft } from "../../../lib/aircraft";
import { useSettings } from "../../../store/hooks";
import { useMapThing } from "../useMapThing";
import type { MapPlan } from "./useMapPlan";

/** The plan that is edited on the map: that of the selected waypoint, the chosen one, or the one that exists. */
export function useOpenPlan(flight: MapPlan): Aircraft {
  const thing = useMapThing();
  const chosen = useSettings(({ choices }) =>
    AIRCRAFT.find((aircraft) => aircraft === choices["map.plan.open"]),
  );
  return thing?.kind === "waypoint"
    ? thing.plan
    : (chosen ?? (flight.waypoints.length === 0 ? "hil" : "flight"));
}
