import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import type { Waypoint } from "../../../lib/plan";
import { checkPlan } from "../../../lib/planCheck";
import { ReplaceDialog } from "../../../missions/ReplaceDialog";
import { useIssueText } from "../../../missions/useIssueText";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { Button } from "../../../ui/Button";
import type { MapPlan } from "../plan/useMapPlan";
import { usePatternPlan } from "./usePatternPlan";

interface Props {
  aircraft: Aircraft;
  plan: MapPlan;
  /** Null: there is none yet, for this reason. */
  pattern: readonly Waypoint[] | null;
  missing: string;
}

/** Puts a pattern into the plan: behind it or in its place; with what is wrong with it. */
export function PatternButtons({ aircraft, plan, pattern, missing }: Props) {
  const { t } = useTranslation();
  const text = useIssueText();
  const { put, fault } = usePatternPlan(aircraft, plan);
  const [isAsking, setAsking] = useState(false);
  const issues = pattern === null ? [] : checkPlan(pattern, PLAN_LIMITS);
  const isUnsent = plan.waypoints.length > 0 && plan.state !== "same";
  const error = issues.find(({ level, code }) => level === "error" && code !== "count");
  const refused = error === undefined ? undefined : text(error);
  const reason = (isInstead: boolean): string | undefined =>
    pattern === null ? missing : (fault(pattern, isInstead) ?? refused);
  const warning = issues.find(({ level }) => level === "warning");
  return (
    <>
      {pattern !== null && <p role="status">{t("map.pattern.makes", { count: pattern.length })}</p>}
      {warning !== undefined && <p className="map-plan-hint">{text(warning)}</p>}
      <div className="map-plan-buttons">
        <Button
          takesFields
          variant="primary"
          onPress={() => (isUnsent ? setAsking(true) : pattern !== null && put(pattern, true))}
          disabledReason={reason(true)}
        >
          {t("map.pattern.replace")}
        </Button>
        <Button
          takesFields
          onPress={() => pattern !== null && put(pattern, false)}
          disabledReason={reason(false)}
        >
          {t("map.pattern.append")}
        </Button>
      </div>
      {isAsking && (
        <ReplaceDialog
          onConfirm={() => pattern !== null && put(pattern, true)}
          onClose={() => setAsking(false)}
        />
      )}
    </>
  );
}
