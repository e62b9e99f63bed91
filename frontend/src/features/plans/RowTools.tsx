import { ArrowDown, ArrowUp, Plus, Redo2, Trash2, Undo2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { MISSIONS, redoPlan, undoPlan, usePlans } from "../../missions/planDrafts";
import { PLAN_LIMITS, type PlanName } from "../../protocol/missions";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import type { PlanEdit } from "./useEditing";

interface Props {
  plan: PlanName;
  selected: number | null;
  count: number;
  /** A plan of the past. */
  isFixed: boolean;
  edit: PlanEdit;
}

/** Buttons for the same row edits as the keys. */
export function RowTools({ plan, selected, count, isFixed, edit }: Props) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const canUndo = usePlans((plans) => plans[plan].draft.past.length > 0);
  const canRedo = usePlans((plans) => plans[plan].draft.future.length > 0);
  const { maximum } = PLAN_LIMITS.count;
  const fixed = isFixed ? t("plans.fixed") : undefined;
  const noRow = fixed ?? (selected === null ? t("plans.noRow") : undefined);
  const icon = { size: 14, "aria-hidden": true } as const;
  return (
    <div className="plans-rows">
      <Button
        onPress={edit.insert}
        icon={<Plus {...icon} />}
        disabledReason={fixed ?? (count >= maximum ? t("plans.isFull", { maximum }) : undefined)}
      >
        {t("plans.insert")}
      </Button>
      <Button onPress={edit.remove} icon={<Trash2 {...icon} />} disabledReason={noRow}>
        {t("plans.remove")}
      </Button>
      <Button
        onPress={() => edit.move(-1)}
        icon={<ArrowUp {...icon} />}
        disabledReason={noRow ?? (selected === 0 ? t("plans.isFirst") : undefined)}
      >
        {t("plans.up")}
      </Button>
      <Button
        onPress={() => edit.move(1)}
        icon={<ArrowDown {...icon} />}
        disabledReason={noRow ?? (selected === count - 1 ? t("plans.isLast") : undefined)}
      >
        {t("plans.down")}
      </Button>
      <span className="plans-gap" />
      <Button
        onPress={() => undoPlan(missions.plans, plan)}
        icon={<Undo2 {...icon} />}
        disabledReason={fixed ?? (canUndo ? undefined : t("plans.noUndo"))}
        label={t("plans.undo")}
      >
        {null}
      </Button>
      <Button
        onPress={() => redoPlan(missions.plans, plan)}
        icon={<Redo2 {...icon} />}
        disabledReason={fixed ?? (canRedo ? undefined : t("plans.noRedo"))}
        label={t("plans.redo")}
      >
        {null}
      </Button>
    </div>
  );
}
