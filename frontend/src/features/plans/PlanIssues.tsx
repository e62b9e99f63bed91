import { useTranslation } from "react-i18next";
import type { WaypointField } from "../../lib/plan";
import type { PlanIssue } from "../../lib/planCheck";
import { useIssueText } from "../../missions/useIssueText";

interface Props {
  issues: readonly PlanIssue[];
  onGo: (row: number, field: WaypointField) => void;
}

/** The plan's issues: errors, which prevent its upload, before warnings, which do not. */
export function PlanIssues({ issues, onGo }: Props) {
  const { t } = useTranslation();
  const text = useIssueText();
  const errors = issues.filter(({ level }) => level === "error");
  const warnings = issues.filter(({ level }) => level === "warning");
  return (
    <div className="plans-issues">
      <p role="status">
        {issues.length === 0
          ? t("plans.noIssues")
          : `${t("plans.errors", { count: errors.length })} · ${t("plans.warnings", { count: warnings.length })}`}
      </p>
      <ul>
        {[...errors, ...warnings].map((issue) => (
          <li key={`${issue.code} ${issue.row} ${issue.field}`} data-level={issue.level}>
            {issue.row === null ? (
              text(issue)
            ) : (
              <button
                type="button"
                className="plans-issue"
                onClick={() => issue.row !== null && onGo(issue.row, issue.field ?? "latitude_deg")}
              >
                {text(issue)}
              </button>
            )}
          </li>
        ))}
      </ul>
    </div>
  );
}
