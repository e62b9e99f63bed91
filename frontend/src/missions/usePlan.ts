import { useMemo } from "react";
import type { Waypoint } from "../lib/plan";
import { checkPlan, type PlanIssue } from "../lib/planCheck";
import { PLAN_LIMITS, type PlanName } from "../protocol/missions";
import { useTelemetry } from "../store/hooks";
import { hazardsOf, type PlanState, planState, usePlans } from "./planDrafts";
import { PLAN } from "./planFacts";

export interface ShownPlan {
  readonly waypoints: readonly Waypoint[];
  readonly issues: readonly PlanIssue[];
  readonly state: PlanState;
  /** Index of the waypoint that the board reports to fly to; null if not live. */
  readonly flownTo: number | null;
  /** The same if the shown plan is the board's, else null: only then it is an index into the shown rows. */
  readonly active: number | null;
  /** A plan of the past: no edit changes it. */
  readonly isFixed: boolean;
}

/** A plan's draft, its faults, and the board's progress in it. */
export function usePlan(plan: PlanName): ShownPlan {
  const waypoints = usePlans((plans) => plans[plan].draft.present);
  const state = usePlans((plans) => planState(plans[plan]));
  const isFixed = usePlans((plans) => plans[plan].isFixed);
  const hazards = usePlans((plans) => hazardsOf(plans[plan]));
  const issues = useMemo(
    () => (isFixed && waypoints.length === 0 ? [] : [...checkPlan(waypoints, PLAN_LIMITS), ...hazards]),
    [isFixed, waypoints, hazards],
  );
  const flownTo = useTelemetry((telemetry, now_ms) =>
    telemetry.liveNumber(PLAN[plan].topic, "waypoint", now_ms),
  );
  const active = state === "same" && flownTo !== null && flownTo < waypoints.length ? flownTo : null;
  return { waypoints, issues, state, flownTo, active, isFixed };
}
