import { useTranslation } from "react-i18next";
import { sameRow } from "../../../lib/plan";
import { useNoTransfer } from "../../../missions/useNoTransfer";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { useBoardBlocked } from "../../../requests/useBlocked";
import type { MapPlan } from "./useMapPlan";

/** Why the board cannot be sent to a place of the map now; undefined if it can. */
export function useFlyHereBlocked(plan: MapPlan): string | undefined {
  const { t } = useTranslation();
  const { maximum } = PLAN_LIMITS.count;
  return (
    useSendBlocked(plan) ?? (plan.waypoints.length >= maximum ? t("plans.isFull", { maximum }) : undefined)
  );
}

/** Why the plan cannot be sent as it is, with one of its waypoints changed; undefined if it can. */
export function useSendBlocked(plan: MapPlan): string | undefined {
  const { t } = useTranslation();
  const blocked = useBoardBlocked();
  const unsupported = useNoTransfer().short;
  const errors = plan.issues.filter(({ level, code }) => level === "error" && code !== "count").length;
  return (
    blocked ??
    (plan.isFixed ? t("plans.fixed") : undefined) ??
    unsupported ??
    // What is not known would be overwritten.
    (plan.onBoard === null && plan.waypoints.length === 0 ? t("map.fly.readFirst") : undefined) ??
    (errors > 0 ? t("plans.fixFirst", { count: errors }) : undefined)
  );
}

/** The row of the shown plan that the board flies to now; null if it is not known. */
export function flownRow({ waypoints, onBoard, flownTo }: MapPlan): number | null {
  return flownTo === null ? null : sameRow(waypoints, onBoard, flownTo);
}
