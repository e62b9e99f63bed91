import { useTranslation } from "react-i18next";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { EditScope } from "../../ui/openEdits";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { FoldingPanel } from "./panels/FoldingPanel";
import { CircuitForm } from "./patterns/CircuitForm";
import { SurveyForm } from "./patterns/SurveyForm";
import { useMapPlan } from "./plan/useMapPlan";
import { useOpenPlan } from "./plan/useOpenPlan";

const KIND = "map.pattern";
const KINDS = ["circuit", "survey"] as const;

/** Patterns for the plan that is open: an aerodrome circuit, or the survey of an area. */
export function PatternSection() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const kind = useSettings(({ choices }) => KINDS.find((known) => known === choices[KIND]) ?? "circuit");
  const plans = { flight: useMapPlan("flight"), hil: useMapPlan("hil") };
  const open = useOpenPlan(plans.flight);
  const names = { circuit: t("map.pattern.circuit"), survey: t("map.pattern.survey") };
  const Form = kind === "circuit" ? CircuitForm : SurveyForm;
  return (
    <FoldingPanel name="patterns" title={t("map.pattern.title")} isFoldedFirst>
      <p className="map-plan-hint">{t("map.pattern.into", { plan: t(`planName.${open}`) })}</p>
      <SegmentedSwitch
        label={t("map.pattern.title")}
        hideLabel
        options={KINDS.map((value) => ({ value, label: names[value] }))}
        value={kind}
        onChange={(value) => choose(settings, KIND, value)}
      />
      <EditScope>
        <Form aircraft={open} plan={plans[open]} />
      </EditScope>
    </FoldingPanel>
  );
}
