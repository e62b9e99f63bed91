import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Waypoint } from "../lib/plan";
import type { PlanName } from "../protocol/missions";
import { useHeightText } from "../readouts/heightSets";
import { useRoleBlocked } from "../requests/useRole";
import { useConnection } from "../store/hooks";
import { Button } from "../ui/Button";
import { Notice } from "../ui/Notice";
import { FlightConditionFields } from "./FlightConditionFields";
import { usePlans } from "./planDrafts";
import { doubtfulHeights, flownIssues, type RehearsalEnd } from "./rehearsal";
import { useIssueText } from "./useIssueText";
import { useRehearsal, useRehearsalText } from "./useRehearsal";
import "./rehearsal.css";

/** Flies a plan in the model at any time, also without a board, and lists what it found with its legs. */
export function RehearsalPanel({ plan, onGo }: { plan: PlanName; onGo: (row: number) => void }) {
  const { t } = useTranslation();
  const waypoints = usePlans((plans) => plans[plan].draft.present);
  const { isFlying, fly } = useRehearsal(plan);
  const [flown, setFlown] = useState<{ of: readonly Waypoint[]; end: RehearsalEnd } | null>(null);
  const isOpen = useConnection(({ phase }) => phase === "open");
  const role = useRoleBlocked("operator");
  const blocked = isOpen
    ? (role ?? (waypoints.length === 0 ? t("plans.nothingToExport") : undefined))
    : t("blocked.gateway");
  return (
    <section className="plans-rehearsal" aria-label={t("rehearsal.title")}>
      <div className="plans-rehearsal-fields">
        <FlightConditionFields plan={plan} />
        <Button
          onPress={() => void fly(0).then((end) => setFlown({ of: waypoints, end }))}
          state={isFlying ? "pending" : "idle"}
          disabledReason={isFlying ? t("rehearsal.flying") : blocked}
        >
          {t("rehearsal.fly")}
        </Button>
      </div>
      {/* What was flown is another plan once this one is edited. */}
      {flown?.of === waypoints && <Outcome end={flown.end} onGo={onGo} />}
    </section>
  );
}

function Outcome({ end, onGo }: { end: RehearsalEnd; onGo: (row: number) => void }) {
  const { t } = useTranslation();
  const text = useRehearsalText();
  const issueText = useIssueText();
  const heightText = useHeightText();
  const issues = flownIssues(end);
  return (
    <>
      <p role="status">
        {text(end)} {end.answer.ok && issues.length === 0 && t("rehearsal.clean")}
      </p>
      {doubtfulHeights(end).map((set) => (
        <Notice key={set.name} level="warning">
          {heightText(set)}
        </Notice>
      ))}
      <ul className="plans-rehearsal-found">
        {issues.map((issue) => (
          <li key={`${issue.code} ${issue.row}`}>
            <button type="button" onClick={() => onGo(issue.row)}>
              {issueText(issue)}
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}
