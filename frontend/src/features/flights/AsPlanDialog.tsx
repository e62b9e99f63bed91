import { useState } from "react";
import { useTranslation } from "react-i18next";
import { MISSIONS, usePlans } from "../../missions/planDrafts";
import { usePlan } from "../../missions/usePlan";
import type { Flight } from "../../protocol/guards.gen";
import { PLANS, type PlanName } from "../../protocol/missions";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Dialog } from "../../ui/Dialog";
import { Notice } from "../../ui/Notice";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { flightName } from "./useFlights";

/** Which track of a flight is to become the plan of its aircraft; its figures are asked about before it is taken. */
export function AsPlanDialog({ flight, onClose }: { readonly flight: Flight; readonly onClose: () => void }) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const [track, setTrack] = useState<PlanName>("hil");
  const isFixed = usePlans((plans) => plans[track].isFixed);
  const { waypoints, state } = usePlan(track);
  const name = flightName(flight);

  function read(): void {
    onClose();
    void missions.importPlan(track, { name, flight: flight.id, track }, { control: `plan.import.${track}` });
  }

  return (
    <Dialog
      title={t("flights.asPlanTitle", { name })}
      description={t("flights.asPlanText")}
      onClose={onClose}
      actions={
        <>
          <Button onPress={onClose}>{t("flights.cancel")}</Button>
          <Button variant="primary" onPress={read} disabledReason={isFixed ? t("plans.fixed") : undefined}>
            {t("flights.asPlanRead")}
          </Button>
        </>
      }
    >
      <SegmentedSwitch
        label={t("flights.asPlanTrack")}
        options={PLANS.map((value) => ({ value, label: t(`asPlanOf.${value}`) }))}
        value={track}
        onChange={setTrack}
      />
      {waypoints.length > 0 && state !== "same" && <Notice level="warning">{t("plans.replaceText")}</Notice>}
    </Dialog>
  );
}
