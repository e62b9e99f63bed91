import { useEffect } from "react";
import { fenceHazards, groundHazards } from "../../../lib/planHazards";
import { MISSIONS, noteHazards, usePlans } from "../../../missions/planDrafts";
import type { PlanName } from "../../../protocol/missions";
import { usePart } from "../../../store/hooks";
import { useSurroundings } from "../surroundings/useSurroundings";
import { useProfile } from "./useProfile";

/** Works out where the draft of a plan leaves the station's fence or meets the ground, while it is drawn. */
export function PlanHazards({ plan }: { plan: PlanName }) {
  const { plans } = usePart(MISSIONS);
  const waypoints = usePlans((all) => all[plan].draft.present);
  const choice = useSurroundings((state) => state.choice);
  const { clearance } = useProfile(waypoints);
  useEffect(() => {
    const fence = choice === null ? [] : fenceHazards(waypoints, choice);
    noteHazards(plans, plan, { of: waypoints, issues: [...fence, ...groundHazards(clearance)] });
  }, [plans, plan, waypoints, choice, clearance]);
  return null;
}
