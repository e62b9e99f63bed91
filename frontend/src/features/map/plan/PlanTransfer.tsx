import { Download, Plus, Redo2, Trash2, Undo2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Whose } from "../../../lib/mapThing";
import { inserted, removed } from "../../../lib/plan";
import { editPlan, MISSIONS, redoPlan, undoPlan } from "../../../missions/planDrafts";
import { SendPlan } from "../../../missions/SendPlan";
import { usePlans } from "../../../missions/usePlans";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { useAsked } from "../../../requests/useAsked";
import { useBoardBlocked } from "../../../requests/useBlocked";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { ConfirmDialog } from "../../../ui/ConfirmDialog";
import { Notice } from "../../../ui/Notice";
import { MAP_SELECTION, selectThing } from "../mapSelection";
import type { MapPlan } from "./useMapPlan";

interface Props {
  whose: Whose;
  plan: MapPlan;
  /** The waypoint that is chosen. */
  row: number | null;
}

/** From the board and to it, and what is done to the plan as a whole. */
export function PlanTransfer({ whose, plan, row }: Props) {
  return (
    <>
      <Transfer whose={whose} plan={plan} />
      <Rows whose={whose} plan={plan} row={row} />
    </>
  );
}

function Transfer({ whose, plan }: Omit<Props, "row">) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const download = useAsked(`plan.download.${whose}`);
  const upload = useAsked(`plan.upload.${whose}`);
  const goTo = useAsked(`plan.goTo.${whose}`);
  const isDraft = usePlans((plans) => plans[whose].draft.present.length > 0);
  const [isAsking, setAsking] = useState(false);
  const blocked = useBoardBlocked();
  const unsupported = plan.canTransfer ? undefined : t("plans.unsupportedShort");
  const errors = plan.issues.filter(({ level }) => level === "error").length;
  const nothing = isDraft
    ? errors > 0
      ? t("plans.fixFirst", { count: errors })
      : undefined
    : t("map.plan.nothingEdited");
  const read = (): void => void missions.download(whose, { control: `plan.download.${whose}` });
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
        <SendPlan plan={whose} onBoard={plan.onBoard} disabledReason={blocked ?? unsupported ?? nothing}>
          {t("map.plan.send")}
        </SendPlan>
      </div>
      {!plan.canTransfer && <Notice level="info">{t("plans.unsupported")}</Notice>}
      {[download, upload, goTo]
        .filter(({ state }) => state === "rejected" || state === "timed_out")
        .map(({ stateText }) => (
          <Notice key={stateText} level="error">
            {stateText}
          </Notice>
        ))}
      {isAsking && (
        <ConfirmDialog
          title={t("plans.replaceTitle")}
          text={t("plans.replaceText")}
          confirmLabel={t("plans.replace")}
          cancelLabel={t("plans.keep")}
          onConfirm={() => {
            setAsking(false);
            read();
          }}
          onCancel={() => setAsking(false)}
        />
      )}
    </>
  );
}

function Rows({ whose, plan, row }: Props) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const mapSelection = usePart(MAP_SELECTION);
  const canUndo = usePlans((plans) => plans[whose].draft.past.length > 0);
  const canRedo = usePlans((plans) => plans[whose].draft.future.length > 0);
  const { waypoints } = plan;
  const { maximum } = PLAN_LIMITS.count;
  const icon = { size: 14, "aria-hidden": true } as const;

  function insert(): void {
    const behind = row ?? waypoints.length - 1;
    editPlan(missions.plans, whose, inserted(waypoints, behind));
    selectThing(mapSelection, { kind: "waypoint", plan: whose, row: behind + 1 });
  }

  function remove(at: number): void {
    editPlan(missions.plans, whose, removed(waypoints, at));
    const left = waypoints.length - 1;
    selectThing(
      mapSelection,
      left === 0 ? null : { kind: "waypoint", plan: whose, row: Math.min(at, left - 1) },
    );
  }

  return (
    <div className="map-plan-buttons">
      <Button
        onPress={insert}
        icon={<Plus {...icon} />}
        disabledReason={waypoints.length >= maximum ? t("plans.isFull", { maximum }) : undefined}
      >
        {row === null ? t("map.plan.append") : t("map.plan.insertAfter", { number: row + 1 })}
      </Button>
      <Button
        onPress={() => row !== null && remove(row)}
        icon={<Trash2 {...icon} />}
        label={t("plans.remove")}
        disabledReason={row === null ? t("plans.noRow") : undefined}
      >
        {null}
      </Button>
      <Button
        onPress={() => undoPlan(missions.plans, whose)}
        icon={<Undo2 {...icon} />}
        label={t("plans.undo")}
        disabledReason={canUndo ? undefined : t("plans.noUndo")}
      >
        {null}
      </Button>
      <Button
        onPress={() => redoPlan(missions.plans, whose)}
        icon={<Redo2 {...icon} />}
        label={t("plans.redo")}
        disabledReason={canRedo ? undefined : t("plans.noRedo")}
      >
        {null}
      </Button>
    </div>
  );
}
