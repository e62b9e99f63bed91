import { useTranslation } from "react-i18next";
import { legsOf } from "../../lib/plan";
import type { ShownPlan } from "../../missions/usePlan";
import { useUnit } from "../../readouts/useUnit";

/** One line about the plan: whether the board has it, where the board flies to, its length. */
export function PlanHead({ shown }: { shown: ShownPlan }) {
  const { t } = useTranslation();
  const distance = useUnit("distance");
  const { waypoints, state, flownTo } = shown;
  const total_m = legsOf(waypoints).reduce((sum, leg) => sum + leg.distance_m, 0);
  return (
    <p className="plans-head">
      <span className="plans-state" data-state={state} role="status">
        {t(`planState.${state}`)}
      </span>
      <span>{flownTo === null ? t("plans.flownToNone") : t("plans.flownTo", { number: flownTo + 1 })}</span>
      <span>
        {t("plans.total", {
          distance: `${distance.format(total_m) ?? t("words.dash")} ${distance.label}`,
          count: waypoints.length,
        })}
      </span>
    </p>
  );
}
