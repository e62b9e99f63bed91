import { useTranslation } from "react-i18next";
import { AutopilotSwitch } from "../../features/controls/AutomaticSwitches";
import { FlightSentence } from "../../features/fly/FlightSentence";
import { FlightMap } from "../../features/map/PlanMap";
import { PLAN } from "../../missions/planFacts";
import { useFlownAircraft } from "../../readouts/flownAircraft";
import { CommandButton } from "../../requests/CommandButton";

/** The flight view beside its display: one sentence, the map, and what a pilot presses. */
export function FlyTab() {
  const aircraft = useFlownAircraft();
  return (
    <div className="fly">
      <FlightSentence />
      <div className="fly-map">
        <FlightMap plan={aircraft} />
      </div>
      <Actions plan={PLAN[aircraft]} />
    </div>
  );
}

/** In a wide window the switch stands in the toolbar, and the style sheet hides this one. */
function Actions({ plan }: { readonly plan: (typeof PLAN)["hil"] }) {
  const { t } = useTranslation();
  return (
    <div className="fly-actions" role="toolbar" aria-label={t("fly.actions")}>
      <AutopilotSwitch />
      <CommandButton command={plan.previous}>{t("fms.previous")}</CommandButton>
      <CommandButton command={plan.next}>{t("fms.next")}</CommandButton>
    </div>
  );
}
