import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import type { Waypoint } from "../../../lib/plan";
import { editPlan, MISSIONS } from "../../../missions/planDrafts";
import { SELECTION, selectThing } from "../../../missions/selection";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { usePart } from "../../../store/hooks";
import type { MapPlan } from "../plan/useMapPlan";

interface PatternPlan {
  /** Put the pattern behind the plan, or in its place; one step of the undo. */
  readonly put: (pattern: readonly Waypoint[], isInstead: boolean) => void;
  /** Why the pattern does not fit, with the board's limits in it; undefined if it does. */
  readonly fault: (pattern: readonly Waypoint[], isInstead: boolean) => string | undefined;
}

export function usePatternPlan(aircraft: Aircraft, { waypoints, isFixed }: MapPlan): PatternPlan {
  const { t } = useTranslation();
  const { plans } = usePart(MISSIONS);
  const selection = usePart(SELECTION);
  const { maximum } = PLAN_LIMITS.count;
  return {
    put: (pattern, isInstead) => {
      editPlan(plans, aircraft, isInstead ? pattern : [...waypoints, ...pattern]);
      selectThing(selection, { kind: "waypoint", plan: aircraft, row: isInstead ? 0 : waypoints.length });
    },
    fault: (pattern, isInstead) => {
      const count = pattern.length + (isInstead ? 0 : waypoints.length);
      if (isFixed) {
        return t("plans.fixed");
      }
      return count > maximum ? t("map.pattern.tooMany", { count, maximum }) : undefined;
    },
  };
}
