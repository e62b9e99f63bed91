import { useMemo } from "react";
import type { Waypoint } from "../lib/plan";
import { checkPlan, type PlanIssue } from "../lib/planCheck";
import { PLAN_LIMITS, type PlanName } from "../protocol/missions";
import { useConnection, useTelemetry } from "../store/hooks";
import { type PlanState, planState } from "./planDrafts";
import { PLAN } from "./planFacts";
import { usePlans } from "./usePlans";

export interface ShownPlan {
  readonly waypoints: readonly Waypoint[];
  readonly issues: readonly PlanIssue[];
  readonly state: PlanState;
  /** Index of the waypoint that the board says it flies to; null while that is not live. */
  readonly flownTo: number | null;
  /** The same, where the board's plan is the one shown: only then does the index belong to a row of it. */
  readonly active: number | null;
  /** The board can send and take plans. */
  readonly canTransfer: boolean;
}

/** A plan as it is edited, what is wrong with it, and what the board makes of it. */
export function usePlan(plan: PlanName): ShownPlan {
  const waypoints = usePlans((plans) => plans[plan].draft.present);
  const state = usePlans((plans) => planState(plans[plan]));
  const issues = useMemo(() => checkPlan(waypoints, PLAN_LIMITS), [waypoints]);
  const flownTo = useTelemetry((telemetry, now_ms) =>
    telemetry.liveNumber(PLAN[plan].topic, "waypoint", now_ms),
  );
  const canTransfer = useConnection(({ status }) => status?.board.features.missions === true);
  const active = state === "same" && flownTo !== null && flownTo < waypoints.length ? flownTo : null;
  return { waypoints, issues, state, flownTo, active, canTransfer };
}
