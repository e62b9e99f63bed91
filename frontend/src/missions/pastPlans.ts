import type { StreamEvent } from "../protocol/envelope";
import { PLANS } from "../protocol/missions";
import type { RequesterParts } from "../requests/asking";
import type { KnownAt } from "../requests/knownAt";
import { createPlanActions } from "./missionRequests";
import { createPlans, fixPlan, forgetBoardPlan, type PlanActions } from "./planDrafts";

/** The plans as they were known at the moment of a flight: what the board had is also what is shown as the draft. */
export function createPastPlans(
  known: KnownAt,
  saveFile: (name: string, content: Blob) => void,
  asking: RequesterParts,
): { readonly actions: PlanActions; readonly takeEvent: (event: StreamEvent) => void } {
  // Without a storage: the drafts that this browser remembers are of the present.
  const plans = createPlans(null);
  for (const plan of PLANS) {
    fixPlan(plans, plan, null);
  }
  known.onKnown((then) => {
    for (const plan of PLANS) {
      fixPlan(plans, plan, then?.missions[plan]?.waypoints ?? null);
    }
  });
  return {
    actions: createPlanActions(plans, saveFile, asking),
    takeEvent: ({ event, data }) => {
      if (event === "mission") {
        // Being written or written: what the board has then is asked for when it is known.
        forgetBoardPlan(plans, data.plan);
        if (data.state !== "pending") {
          void known.read();
        }
      }
    },
  };
}
