import { Download, Plus, Redo2, Trash2, Undo2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { inserted, removed } from "../../../lib/plan";
import { editPlan, MISSIONS, redoPlan, undoPlan, usePlans } from "../../../missions/planDrafts";
import { ReplaceDialog } from "../../../missions/ReplaceDialog";
import { SendPlan } from "../../../missions/SendPlan";
import { SELECTION, selectThing } from "../../../missions/selection";
import { useNoTransfer } from "../../../missions/useNoTransfer";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { useAsked } from "../../../requests/useAsked";
import { useBoardBlocked } from "../../../requests/useBlocked";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { Notice } from "../../../ui/Notice";
import type { MapPlan } from "./useMapPlan";

interface Props {
  aircraft: Aircraft;
  plan: MapPlan;
  /** Index of the selected waypoint. */
  row: number | null;
}

/** Buttons to read the plan from the board, send it, and edit it as a whole. */
export function PlanTransfer({ aircraft, plan, row }: Props) {
  return (
    <>
      <Transfer aircraft={aircraft} plan={plan} />
      <Rows aircraft={aircraft} plan={plan} row={row} />
    </>
  );
}

function Transfer({ aircraft, plan }: Omit<Props, "row">) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const download = useAsked(`plan.download.${aircraft}`);
  const upload = useAsked(`plan.upload.${aircraft}`);
  const goTo = useAsked(`plan.goTo.${aircraft}`);
  const isDraft = usePlans((plans) => plans[aircraft].draft.present.length > 0);
  const [isAsking, setAsking] = useState(false);
  const blocked = useBoardBlocked();
  const { short: unsupported, long: noTransfer } = useNoTransfer();
  const errors = plan.issues.filter(({ level }) => level === "error").length;
  const nothing = isDraft
    ? errors > 0
      ? t("plans.fixFirst", { count: errors })
      : undefined
    : t("map.plan.nothingEdited");
  const read = (): void => void missions.download(aircraft, { control: `plan.download.${aircraft}` });
  return (
    <>
      <div className="map-plan-buttons">
        <Button
          onPress={() => (isDraft && plan.state !== "same" ? setAsking(true) : read())}
          state={download.state}
          stateText={download.stateText}
          disabledReason={blocked ?? unsupported}
          icon={<Download aria-hidden="true" size={14} />}
        >
          {t("map.plan.read")}
        </Button>
        <SendPlan plan={aircraft} onBoard={plan.onBoard} disabledReason={blocked ?? unsupported ?? nothing}>
          {t("map.plan.send")}
        </SendPlan>
      </div>
      {noTransfer !== undefined && !plan.isFixed && <Notice level="info">{noTransfer}</Notice>}
      {[download, upload, goTo]
        .filter(({ state }) => state === "rejected" || state === "timed_out")
        .map(({ stateText }) => (
          <Notice key={stateText} level="error">
            {stateText}
          </Notice>
        ))}
      {isAsking && <ReplaceDialog onConfirm={read} onClose={() => setAsking(false)} />}
    </>
  );
}

function Rows({ aircraft, plan, row }: Props) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const selection = usePart(SELECTION);
  const canUndo = usePlans((plans) => plans[aircraft].draft.past.length > 0);
  const canRedo = usePlans((plans) => plans[aircraft].draft.future.length > 0);
  const { waypoints } = plan;
  const { maximum } = PLAN_LIMITS.count;
  const fixed = plan.isFixed ? t("plans.fixed") : undefined;
  const icon = { size: 14, "aria-hidden": true } as const;

  function insert(): void {
    const behind = row ?? waypoints.length - 1;
    editPlan(missions.plans, aircraft, inserted(waypoints, behind));
    selectThing(selection, { kind: "waypoint", plan: aircraft, row: behind + 1 });
  }

  function remove(at: number): void {
    editPlan(missions.plans, aircraft, removed(waypoints, at));
    const left = waypoints.length - 1;
    selectThing(
      selection,
      left === 0 ? null : { kind: "waypoint", plan: aircraft, row: Math.min(at, left - 1) },
    );
  }

  return (
    <div className="map-plan-buttons">
      <Button
        onPress={insert}
        icon={<Plus {...icon} />}
        disabledReason={fixed ?? (waypoints.length >= maximum ? t("plans.isFull", { maximum }) : undefined)}
      >
        {row === null ? t("map.plan.append") : t("map.plan.insertAfter", { number: row + 1 })}
      </Button>
      <Button
        onPress={() => row !== null && remove(row)}
        icon={<Trash2 {...icon} />}
        label={t("plans.remove")}
        disabledReason={fixed ?? (row === null ? t("plans.noRow") : undefined)}
      >
        {null}
      </Button>
      <Button
        onPress={() => undoPlan(missions.plans, aircraft)}
        icon={<Undo2 {...icon} />}
        label={t("plans.undo")}
        disabledReason={fixed ?? (canUndo ? undefined : t("plans.noUndo"))}
      >
        {null}
      </Button>
      <Button
        onPress={() => redoPlan(missions.plans, aircraft)}
        icon={<Redo2 {...icon} />}
        label={t("plans.redo")}
        disabledReason={fixed ?? (canRedo ? undefined : t("plans.noRedo"))}
      >
        {null}
      </Button>
    </div>
  );
}
