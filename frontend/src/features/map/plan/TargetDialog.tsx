import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import type { Waypoint } from "../../../lib/plan";
import { checkPlan } from "../../../lib/planCheck";
import { editPlan, MISSIONS } from "../../../missions/planDrafts";
import { useIssueText } from "../../../missions/useIssueText";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { useUnit } from "../../../readouts/useUnit";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { Dialog } from "../../../ui/Dialog";
import { Notice } from "../../../ui/Notice";
import { NumberField } from "../../../ui/NumberField";
import { MAP_TOOL, type TargetField, useMapTool } from "../tools/mapTool";
import { flownRow, useSendBlocked } from "./useFlyHere";
import { useMapPlan } from "./useMapPlan";

const QUANTITY = { altitude_ft: "altitude", speed_kt: "speed" } as const;
const TITLE = { altitude_ft: "map.target.altitude_ft", speed_kt: "map.target.speed_kt" } as const;
const STEP: Readonly<Record<TargetField, number>> = { altitude_ft: 10, speed_kt: 1 };

/** Asks for another altitude or speed at the waypoint that is flown to, or says why it cannot be changed now. */
export function TargetDialog({ plan }: { readonly plan: Aircraft }) {
  const field = useMapTool(({ target }) => target);
  const tools = usePart(MAP_TOOL);
  return field === null ? null : (
    <Question opened={plan} field={field} onClose={() => tools.setState({ target: null })} />
  );
}

interface Props {
  /** The aircraft that is looked at when it is asked: the question stays with it. */
  readonly opened: Aircraft;
  readonly field: TargetField;
  readonly onClose: () => void;
}

function Question({ opened, field, onClose }: Props) {
  const [aircraft] = useState(opened);
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const plan = useMapPlan(aircraft);
  const unit = useUnit(QUANTITY[field]);
  const [wanted, setWanted] = useState<number | null>(null);
  const row = flownRow(plan);
  const now = row === null ? null : (plan.waypoints[row]?.[field] ?? null);
  const value = wanted ?? now;
  const changed =
    row === null || value === null
      ? null
      : plan.waypoints.map((waypoint, at) => (at === row ? { ...waypoint, [field]: value } : waypoint));
  const blocked = useBlocked(aircraft, changed);
  const { minimum, maximum } = PLAN_LIMITS.fields[field];

  function send(): void {
    if (changed !== null && row !== null) {
      editPlan(missions.plans, aircraft, changed);
      void missions.upload(aircraft, { control: `plan.upload.${aircraft}` }, row);
      onClose();
    }
  }

  return (
    <Dialog
      title={t(TITLE[field])}
      description={
        row === null ? undefined : t("map.target.text", { plan: t(`planName.${aircraft}`), number: row + 1 })
      }
      onClose={onClose}
      actions={
        <>
          <Button onPress={onClose}>{t("dialog.cancel")}</Button>
          <Button takesFields variant="primary" onPress={send} disabledReason={blocked}>
            {t("map.target.send")}
          </Button>
        </>
      }
    >
      <NumberField
        label={t(field === "altitude_ft" ? "plans.altitude" : "plans.speed")}
        value={value === null ? null : unit.convert(value)}
        minimum={unit.convert(minimum)}
        maximum={unit.convert(maximum)}
        step={STEP[field]}
        format={(shown) => shown.toFixed(unit.digits)}
        unit={unit.label}
        disabledReason={row === null ? blocked : undefined}
        onCommit={(shown) => setWanted(unit.revert(shown))}
      />
      {blocked !== undefined && <Notice level="warning">{blocked}</Notice>}
    </Dialog>
  );
}

/** Why the plan with the changed waypoint cannot be sent now; undefined if it can. */
function useBlocked(aircraft: Aircraft, changed: readonly Waypoint[] | null): string | undefined {
  const { t } = useTranslation();
  const issueText = useIssueText();
  const plan = useMapPlan(aircraft);
  const unsendable = useSendBlocked(plan);
  const error = checkPlan(changed ?? [], PLAN_LIMITS).find(({ level }) => level === "error");
  if (unsendable !== undefined) {
    return unsendable;
  }
  // What else was drawn would be sent with it.
  if (plan.state !== "same") {
    return t("map.target.unsent");
  }
  return changed === null ? t("map.target.unknown") : error === undefined ? undefined : issueText(error);
}
