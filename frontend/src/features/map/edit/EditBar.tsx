import { MapPinPlus, MousePointer2, Redo2, Ruler, Undo2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { MISSIONS, redoPlan, undoPlan, usePlans } from "../../../missions/planDrafts";
import { useWaypointEdits } from "../../../missions/useWaypointEdits";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { useMapPlan } from "../plan/useMapPlan";
import { useOpenPlan } from "../plan/useOpenPlan";
import { useFlat } from "../scenes/useFlat";
import { useGlobe } from "../scenes/useGlobe";
import { chooseTool, MAP_TOOL, type Tool, useMapTool } from "../tools/mapTool";

/** What a press on the map does, over the map; and undo of what was done. */
export function EditBar() {
  const { t } = useTranslation();
  const tools = usePart(MAP_TOOL);
  const missions = usePart(MISSIONS);
  const tool = useMapTool((state) => state.tool);
  const flight = useMapPlan("flight");
  const hil = useMapPlan("hil");
  const open = useOpenPlan(flight);
  const plan = open === "flight" ? flight : hil;
  const edits = useWaypointEdits(open, plan.waypoints, plan.isFixed);
  const canUndo = usePlans((plans) => plans[open].draft.past.length > 0);
  const canRedo = usePlans((plans) => plans[open].draft.future.length > 0);
  const flat = useFlat();
  const globe = useGlobe();
  const missing = (flat.isShown ? flat.scene : globe) === null ? t("map.view.loading") : undefined;
  const icon = { size: 16, "aria-hidden": true } as const;
  const toggle = (wanted: Tool): void => chooseTool(tools, tool === wanted ? "pick" : wanted);
  return (
    <>
      <div className="map-edit-bar" role="toolbar" aria-label={t("map.edit.bar")}>
        <Button
          pressed={tool === "pick"}
          onPress={() => chooseTool(tools, "pick")}
          icon={<MousePointer2 {...icon} />}
          label={t("map.edit.pick")}
        >
          {null}
        </Button>
        <Button
          pressed={tool === "add"}
          onPress={() => toggle("add")}
          icon={<MapPinPlus {...icon} />}
          disabledReason={missing ?? edits.fixed}
        >
          {t("map.edit.add")}
        </Button>
        <Button
          pressed={tool === "measure"}
          onPress={() => toggle("measure")}
          icon={<Ruler {...icon} />}
          label={t("map.edit.measure")}
          disabledReason={missing}
        >
          {null}
        </Button>
        <Button
          onPress={() => undoPlan(missions.plans, open)}
          icon={<Undo2 {...icon} />}
          label={t("map.edit.undo")}
          disabledReason={edits.fixed ?? (canUndo ? undefined : t("plans.noUndo"))}
        >
          {null}
        </Button>
        <Button
          onPress={() => redoPlan(missions.plans, open)}
          icon={<Redo2 {...icon} />}
          label={t("map.edit.redo")}
          disabledReason={edits.fixed ?? (canRedo ? undefined : t("plans.noRedo"))}
        >
          {null}
        </Button>
      </div>
      {tool === "add" && (
        <p className="map-edit-hint" role="status">
          {edits.full ?? t("map.edit.addHint", { plan: t(`planName.${open}`) })}
        </p>
      )}
      {tool === "measure" && <p className="map-edit-hint">{t("map.tools.hint")}</p>}
    </>
  );
}
