import { ChevronLeft, ChevronRight, Download, FileDown, FolderOpen } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { ImportQuestions } from "../../missions/ImportQuestions";
import { MISSIONS, usePlans } from "../../missions/planDrafts";
import { PLAN } from "../../missions/planFacts";
import { SendPlan } from "../../missions/SendPlan";
import { useNoTransfer } from "../../missions/useNoTransfer";
import type { ShownPlan } from "../../missions/usePlan";
import { PLAN_FORMATS, type PlanFormat, type PlanName } from "../../protocol/missions";
import { ACTIONS } from "../../requests/actions";
import { CommandButton } from "../../requests/CommandButton";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked } from "../../requests/useBlocked";
import { useConnection, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { FileButton } from "../../ui/FileButton";
import { Select } from "../../ui/Select";
import { RouteTools } from "./RouteTools";

interface Props {
  plan: PlanName;
  shown: ShownPlan;
  selected: number | null;
  /** Do this, which replaces the plan; where edits would be lost, ask first. */
  onReplace: (replace: () => void) => void;
}

/** What goes between the table, the board and files, and the steps through the plan in flight. */
export function PlanTools({ plan, shown, selected, onReplace }: Props) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const { issues, waypoints } = shown;
  const download = useAsked(`plan.download.${plan}`);
  const onBoard = usePlans((plans) => plans[plan].board);
  const blocked = useBoardBlocked();
  const unsupported = useNoTransfer().short;
  const errors = issues.filter(({ level }) => level === "error").length;
  return (
    <div className="plans-tools">
      <Button
        onPress={() => onReplace(() => void missions.download(plan, { control: `plan.download.${plan}` }))}
        state={download.state}
        stateText={download.stateText}
        disabledReason={blocked ?? unsupported}
        icon={<Download aria-hidden="true" size={14} />}
      >
        {t("plans.download")}
      </Button>
      <SendPlan
        plan={plan}
        onBoard={onBoard}
        disabledReason={
          blocked ??
          unsupported ??
          (waypoints.length === 0
            ? t("plans.nothingToExport")
            : errors > 0
              ? t("plans.fixFirst", { count: errors })
              : undefined)
        }
      >
        {t("plans.upload")}
      </SendPlan>
      <span className="plans-gap" />
      <CommandButton command={PLAN[plan].previous} icon={<ChevronLeft aria-hidden="true" size={14} />}>
        {t("fms.previous")}
      </CommandButton>
      <CommandButton command={PLAN[plan].next} icon={<ChevronRight aria-hidden="true" size={14} />}>
        {t("fms.next")}
      </CommandButton>
      <GoTo plan={plan} shown={shown} selected={selected} />
      <span className="plans-gap" />
      <FileTools plan={plan} count={waypoints.length} onReplace={onReplace} />
      {plan === "hil" && <RouteTools canTransfer={unsupported === undefined} onReplace={onReplace} />}
    </div>
  );
}

/** Let the board fly to the chosen waypoint: possible only where the board has the plan which is shown. */
function GoTo({ plan, shown, selected }: Omit<Props, "onReplace">) {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const { state, stateText } = useAsked(`plan.goTo.${plan}`);
  const blocked = useBoardBlocked();
  const unsupported = useNoTransfer().short;
  const notThere = shown.state === "same" ? undefined : t("plans.notOnBoard");
  const noRow = selected === null ? t("plans.noRow") : undefined;
  return (
    <Button
      onPress={() => {
        if (selected !== null) {
          void actions.command(
            "go_to_waypoint",
            { control: `plan.goTo.${plan}` },
            { plan: PLAN[plan].number, index: selected },
          );
        }
      }}
      state={state}
      stateText={stateText}
      disabledReason={blocked ?? unsupported ?? notThere ?? noRow}
    >
      {selected === null ? t("plans.goToNone") : t("plans.goTo", { number: selected + 1 })}
    </Button>
  );
}

function FileTools({ plan, count, onReplace }: Pick<Props, "plan" | "onReplace"> & { count: number }) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const isFixed = usePlans((plans) => plans[plan].isFixed);
  const [format, setFormat] = useState<PlanFormat>("kml");
  const exporting = useAsked(`plan.export.${plan}`);
  // Files go through the gateway and not to the board: a viewer may have them too.
  const isOpen = useConnection(({ phase }) => phase === "open");
  const blocked = isOpen ? undefined : t("blocked.gateway");
  return (
    <>
      <ImportQuestions plan={plan} />
      <FileButton
        accept=".kml,.kmz,.gpx,.csv,.plan,.waypoints"
        onFile={(file) =>
          onReplace(() => void missions.importPlan(plan, file, { control: `plan.import.${plan}` }))
        }
        disabledReason={isFixed ? t("plans.fixed") : blocked}
        icon={<FolderOpen aria-hidden="true" size={14} />}
      >
        {t("plans.importFile")}
      </FileButton>
      <Select
        label={t("plans.exportAs")}
        hideLabel
        placeholder={t("plans.exportAs")}
        value={format}
        onChange={setFormat}
        options={PLAN_FORMATS.map((value) => ({ value, label: t(`planFormat.${value}`) }))}
      />
      <Button
        onPress={() =>
          void missions.exportFile(plan, format, PLAN[plan].file, { control: `plan.export.${plan}` })
        }
        state={exporting.state}
        stateText={exporting.stateText}
        disabledReason={blocked ?? (count === 0 ? t("plans.nothingToExport") : undefined)}
        icon={<FileDown aria-hidden="true" size={14} />}
      >
        {t("plans.export")}
      </Button>
    </>
  );
}
