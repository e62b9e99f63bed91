import { useMemo } from "react";
import type { Aircraft } from "../../../lib/aircraft";
import { samePlan, type Waypoint } from "../../../lib/plan";
import { checkPlan, type PlanIssue } from "../../../lib/planCheck";
import type { PlanState } from "../../../missions/planDrafts";
import { hazardsOf, usePlans } from "../../../missions/planDrafts";
import { PLAN } from "../../../missions/planFacts";
import { ROUTES } from "../../../protocol/messages.gen";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { useTelemetry } from "../../../store/hooks";

export interface MapPlan {
  /** The shown and edited plan: the draft, or without one, the board's plan. */
  readonly waypoints: readonly Waypoint[];
  /** The board's plan: read back, or the built-in route that it reports; null: unknown. */
  readonly onBoard: readonly Waypoint[] | null;
  readonly state: PlanState;
  readonly issues: readonly PlanIssue[];
  /** Index of the waypoint that the board flies to; null if not live. */
  readonly flownTo: number | null;
  /** What the board does after the last waypoint; null if unknown. */
  readonly ending: "loop" | "hold" | null;
  /** A plan of the past: no edit changes it. */
  readonly isFixed: boolean;
}

const NOTHING: readonly Waypoint[] = [];

/** A plan as the map shows it. */
export function useMapPlan(plan: Aircraft): MapPlan {
  const draft = usePlans((plans) => plans[plan].draft.present);
  const read = usePlans((plans) => plans[plan].board);
  // The last report, however old, as for a plan that was read: a pause of the link must not interrupt an edit.
  const route = useTelemetry((telemetry) =>
    plan === "hil" ? telemetry.newestNumber("board_status", "hil_plan_name") : null,
  );
  const flownTo = useTelemetry((telemetry, now_ms) =>
    telemetry.liveNumber(PLAN[plan].topic, "waypoint", now_ms),
  );
  const isFixed = usePlans((plans) => plans[plan].isFixed);
  const named = ROUTES.find(({ planName }) => planName === route);
  const onBoard = read ?? named?.waypoints ?? null;
  const waypoints = draft.length === 0 ? (onBoard ?? NOTHING) : draft;
  const hazards = usePlans((plans) => hazardsOf(plans[plan]));
  const issues = useMemo(
    () => (isFixed && waypoints.length === 0 ? [] : [...checkPlan(waypoints, PLAN_LIMITS), ...hazards]),
    [isFixed, waypoints, hazards],
  );
  return {
    waypoints,
    onBoard,
    state: stateOf(waypoints, onBoard),
    issues,
    flownTo,
    ending: plan === "flight" || route === -1 ? "hold" : named === undefined ? null : endingOf(named),
    isFixed,
  };
}

function endingOf({ loop }: { readonly loop: boolean }): "loop" | "hold" {
  return loop ? "loop" : "hold";
}

function stateOf(waypoints: readonly Waypoint[], onBoard: readonly Waypoint[] | null): PlanState {
  if (waypoints.length === 0) {
    return "empty";
  }
  return onBoard === null ? "unknown" : samePlan(waypoints, onBoard) ? "same" : "differs";
}
