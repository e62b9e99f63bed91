import type { StreamEvent } from "../protocol/envelope";
import { isMissionEvent, PLANS } from "../protocol/missions";
import type { AskingParts } from "../requests/asking";
import type { KnownAt } from "../requests/knownAt";
import { createPlanActions } from "./missionRequests";
import { boardHas, createPlans, editPlan, forgetBoardPlan, type PlanActions } from "./planDrafts";

/** The plans as they were known at the moment of a flight: what the board had is also what is shown as the draft. */
export function createPastPlans(
  known: KnownAt,
  saveFile: (name: string, content: Blob) => void,
  asking: AskingParts,
): { readonly actions: PlanActions; readonly takeEvent: (event: StreamEvent) => void } {
  // Without a storage: the drafts that this browser remembers are of the present.
  const plans = createPlans(null);
  known.onKnown((then) => {
    for (const plan of PLANS) {
      const waypoints = then?.missions[plan]?.waypoints ?? null;
      editPlan(plans, plan, waypoints ?? []);
      if (waypoints === null) {
        forgetBoardPlan(plans, plan);
      } else {
        boardHas(plans, plan, waypoints);
      }
    }
  });
  return {
    actions: createPlanActions(plans, saveFile, asking),
    takeEvent: ({ event, data }) => {
      if (event === "mission" && isMissionEvent(data)) {
        // Being written or written: what the board has then is asked for when it is known.
        forgetBoardPlan(plans, data.plan);
        if (data.state !== "pending") {
          void known.read();
        }
      }
    },
  };
}
