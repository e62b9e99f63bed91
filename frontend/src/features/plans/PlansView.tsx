import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { PLANS, type PlanName } from "../../protocol/missions";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Tabs } from "../../ui/Tabs";
import { PlanEditor } from "./PlanEditor";
import "./plans.css";

/** "Planes de vuelo": the plan of the aircraft and that of the HIL aircraft. */
export function PlansView({ map }: { map: (plan: PlanName) => ReactNode }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const open = useSettings(({ choices }) => PLANS.find((plan) => plan === choices["plans.open"]) ?? "flight");
  return (
    <Tabs
      label={t("plans.tabs")}
      className="plans"
      value={open}
      onValueChange={(plan) => choose(settings, "plans.open", plan)}
      tabs={PLANS.map((plan) => ({
        value: plan,
        label: t(`planName.${plan}`),
        content: <PlanEditor plan={plan} map={map(plan)} />,
      }))}
    />
  );
}
