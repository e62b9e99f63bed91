import { Crosshair, SquareDashedMousePointer, Trash2, Undo2 } from "lucide-react";
import { useEffect, useMemo, useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { type Survey, survey } from "../../../lib/planPatterns";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import type { MapPlan } from "../plan/useMapPlan";
import { useScreenTools } from "../scenes/useScreenTools";
import { chooseTool, MAP_TOOL, useMapTool } from "../tools/mapTool";
import { PatternButtons } from "./PatternButtons";
import { AngleField, HeightField, LengthField, SpeedField } from "./PatternFields";

const USUAL: Survey = { spacing_m: 250, angle_deg: 0, overshoot_m: 100, altitude_ft: 1000, speed_kt: 55 };

/** Lines over an area that is marked on the map: a polygon, or a rectangle by two corners. */
export function SurveyForm({ aircraft, plan }: { aircraft: Aircraft; plan: MapPlan }) {
  const { t } = useTranslation();
  const mapTool = usePart(MAP_TOOL);
  const tools = useScreenTools();
  const area = useMapTool((state) => state.area);
  const isMarking = useMapTool(({ tool }) => tool === "area");
  const [wanted, setWanted] = useState<Survey>(USUAL);
  const planned = useMemo(() => survey(area, wanted), [area, wanted]);
  const set = (part: Partial<Survey>): void => setWanted({ ...wanted, ...part });
  const missing = tools === null ? t("map.view.loading") : undefined;
  const nothing = area.length === 0 ? t("map.pattern.noArea") : undefined;
  const { minimum, maximum } = PLAN_LIMITS.fields.altitude_ft;
  const icon = { size: 14, "aria-hidden": true } as const;

  useEffect(() => {
    if (!isMarking) return undefined;
    tools?.measure((place) => mapTool.setState((state) => ({ area: [...state.area, place] })));
    return () => tools?.measure(null);
  }, [tools, mapTool, isMarking]);
  useEffect(() => {
    const outline = area.length > 2 ? [...area, ...area.slice(0, 1)] : area;
    tools?.showArea(outline.map((place) => ({ ...place, label: "" })));
  }, [tools, area]);
  // The outline is part of this form, and goes with it.
  useEffect(
    () => () => {
      tools?.showArea([]);
      if (mapTool.getState().tool === "area") chooseTool(mapTool, "pick");
    },
    [tools, mapTool],
  );

  return (
    <div className="map-plan-fields">
      <div className="map-plan-buttons">
        <Button
          pressed={isMarking}
          onPress={() => chooseTool(mapTool, isMarking ? "pick" : "area")}
          icon={<SquareDashedMousePointer {...icon} />}
          disabledReason={missing}
        >
          {t("map.pattern.mark")}
        </Button>
        <Button
          onPress={() => {
            const place = tools?.centre() ?? null;
            if (place !== null) mapTool.setState({ area: [...area, place] });
          }}
          icon={<Crosshair {...icon} />}
          disabledReason={missing}
        >
          {t("map.pattern.cornerHere")}
        </Button>
        <Button
          onPress={() => mapTool.setState({ area: area.slice(0, -1) })}
          icon={<Undo2 {...icon} />}
          label={t("map.pattern.cornerUndo")}
          disabledReason={nothing}
        >
          {null}
        </Button>
        <Button
          onPress={() => mapTool.setState({ area: [] })}
          icon={<Trash2 {...icon} />}
          label={t("map.pattern.cornerClear")}
          disabledReason={nothing}
        >
          {null}
        </Button>
      </div>
      <p className="map-plan-hint">{t("map.pattern.areaHint")}</p>
      <LengthField
        label={t("map.pattern.spacing")}
        value_m={wanted.spacing_m}
        minimum_m={10}
        maximum_m={5000}
        onCommit={(spacing_m) => set({ spacing_m })}
      />
      <AngleField
        label={t("map.pattern.angle")}
        value={wanted.angle_deg}
        onCommit={(angle_deg) => set({ angle_deg })}
      />
      <LengthField
        label={t("map.pattern.overshoot")}
        value_m={wanted.overshoot_m}
        minimum_m={0}
        maximum_m={2000}
        onCommit={(overshoot_m) => set({ overshoot_m })}
      />
      <HeightField
        label={t("plans.altitude")}
        value={wanted.altitude_ft}
        minimum={minimum}
        maximum={maximum}
        onCommit={(altitude_ft) => set({ altitude_ft })}
      />
      <SpeedField value={wanted.speed_kt} onCommit={(speed_kt) => set({ speed_kt })} />
      {planned !== null && (
        <p className="map-plan-hint">
          {planned.stride === 1
            ? t("map.pattern.lines", { count: planned.lines })
            : t("map.pattern.strided", { count: planned.lines, stride: planned.stride })}
        </p>
      )}
      <PatternButtons
        aircraft={aircraft}
        plan={plan}
        pattern={planned?.waypoints ?? null}
        missing={area.length < 2 ? t("map.pattern.twoCorners") : t("map.pattern.noLines")}
      />
    </div>
  );
}
