import { type ReactNode, useState } from "react";
import { useTranslation } from "react-i18next";
import { PLANS, type PlanName } from "../../protocol/missions";
import { usePage, useSettings, useTelemetry } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Tabs } from "../../ui/Tabs";
import { PlanEditor } from "./PlanEditor";
import "./plans.css";

/** "Planes de vuelo": the plan of the aircraft and that of the HIL aircraft; first the one that is flown. */
export function PlansView({ map }: { map: (plan: PlanName) => ReactNode }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const chosen = useSettings(({ choices }) => PLANS.find((plan) => plan === choices["plans.open"]));
  const isSimulated = useTelemetry((telemetry, now_ms) => telemetry.state("simulator", now_ms) === "live");
  // As it was when the tab was opened: a stream that comes or goes does not change the plan under a hand.
  const [inUse] = useState<PlanName>(isSimulated ? "hil" : "flight");
  const open = chosen ?? inUse;
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
