import { Flag } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { AutopilotSwitch } from "../../features/controls/AutomaticSwitches";
import { FlightSentence } from "../../features/fly/FlightSentence";
import { FlightMap } from "../../features/map/PlanMap";
import { FlightProfile } from "../../features/map/profile/FlightProfile";
import { MarkDialog } from "../../features/playback/MarkDialog";
import { useIsRecording, usePlayback } from "../../features/playback/usePlayback";
import { PLAN } from "../../missions/planFacts";
import { useFlownAircraft } from "../../readouts/flownAircraft";
import { CommandButton } from "../../requests/CommandButton";
import { Button } from "../../ui/Button";

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
      <FlightProfile plan={aircraft} />
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
      <Mark />
    </div>
  );
}

/** Marks this moment of the flight: Enter sets the mark, its words can come later. */
function Mark() {
  const { t } = useTranslation();
  const isRecording = useIsRecording();
  const isPast = usePlayback(({ flight }) => flight !== null);
  const [isAsking, setAsking] = useState(false);
  return (
    <>
      <Button
        onPress={() => setAsking(true)}
        label={t("time.markLong")}
        disabledReason={isRecording || isPast ? undefined : t("time.none")}
        icon={<Flag size={16} aria-hidden="true" />}
      >
        {t("time.mark")}
      </Button>
      {isAsking && <MarkDialog onClose={() => setAsking(false)} />}
    </>
  );
}
