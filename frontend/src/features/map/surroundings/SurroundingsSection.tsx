import { Crosshair, Redo2, Save, Spline, Trash2, Undo2 } from "lucide-react";
import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../../i18n/useSentence";
import { crossingSides } from "../../../lib/fenceBorder";
import type { SurroundingsChoice } from "../../../protocol/guards.gen";
import { useUnit } from "../../../readouts/useUnit";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { Checkbox } from "../../../ui/Checkbox";
import { Notice } from "../../../ui/Notice";
import { NumberField } from "../../../ui/NumberField";
import { FoldingPanel } from "../panels/FoldingPanel";
import { useScreenTools } from "../scenes/useScreenTools";
import { chooseTool, MAP_TOOL, useMapTool } from "../tools/mapTool";
import { AroundNow } from "./AroundNow";
import { FenceFiles } from "./FenceFiles";
import { OneCorner } from "./OneCorner";
import { isSaved, LEAST_CORNERS, MOST_CORNERS, SURROUNDINGS } from "./surroundings";
import { useFixed, useSurroundings } from "./useSurroundings";
import "./surroundings.css";

const HEIGHTS = { margin: [30, 3000], fence: [0, 3000], ceiling: [-1500, 60_000] } as const;
/** A ceiling that is wanted and has no height yet, feet above the sea. */
const FIRST_CEILING_FT = 1500;

/** Ground and fence: what is around the aircraft, which warnings are wanted, and the fence itself. */
export function SurroundingsSection() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const choice = useSurroundings((state) => state.choice);
  const failure = useSurroundings((state) => state.failure);
  return (
    <FoldingPanel name="around" title={t("map.around.title")} isFoldedFirst className="map-around">
      <AroundNow />
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
      {choice !== null && <Choice choice={choice} />}
      <p className="map-plan-hint">{t("map.around.advice")}</p>
    </FoldingPanel>
  );
}

function Choice({ choice }: { choice: SurroundingsChoice }) {
  const { t } = useTranslation();
  const { choose } = usePart(SURROUNDINGS);
  const fixed = useFixed();
  const isNothing = choice.corners.length === 0 && choice.ceiling_ft === null;
  return (
    <>
      <fieldset className="map-around-part">
        <legend>{t("map.around.ground")}</legend>
        <Checkbox
          label={t("map.around.groundOn")}
          checked={choice.terrain_on}
          onChange={(terrain_on) => void choose({ terrain_on })}
          disabledReason={fixed}
        />
        <Height
          label={t("map.around.margin")}
          value_ft={choice.margin_ft}
          range={HEIGHTS.margin}
          onCommit={(margin_ft) => void choose({ margin_ft })}
        />
      </fieldset>
      <fieldset className="map-around-part">
        <legend>{t("map.around.fence")}</legend>
        <Checkbox
          label={t("map.around.fenceOn")}
          checked={choice.fence_on}
          onChange={(fence_on) => void choose({ fence_on })}
          disabledReason={fixed ?? (isNothing && !choice.fence_on ? t("map.around.noFence") : undefined)}
        />
        <Border />
        <Checkbox
          label={t("map.around.ceilingOn")}
          checked={choice.ceiling_ft !== null}
          onChange={(isOn) =>
            void choose({
              ceiling_ft: isOn ? FIRST_CEILING_FT : null,
              // Without a border and a ceiling there is nothing to watch.
              fence_on: choice.fence_on && (isOn || choice.corners.length > 0),
            })
          }
          disabledReason={fixed}
        />
        {choice.ceiling_ft !== null && (
          <Height
            label={t("map.around.ceiling")}
            value_ft={choice.ceiling_ft}
            range={HEIGHTS.ceiling}
            onCommit={(ceiling_ft) => void choose({ ceiling_ft })}
          />
        )}
        <Height
          label={t("map.around.fenceMargin")}
          value_ft={choice.fence_margin_ft}
          range={HEIGHTS.fence}
          onCommit={(fence_margin_ft) => void choose({ fence_margin_ft })}
        />
      </fieldset>
    </>
  );
}

interface HeightProps {
  label: string;
  value_ft: number;
  range: readonly [number, number];
  onCommit: (value_ft: number) => void;
}

function Height({ label, value_ft, range, onCommit }: HeightProps) {
  const altitude = useUnit("altitude");
  const fixed = useFixed();
  const within = (value: number): number => Math.min(range[1], Math.max(range[0], value));
  return (
    <NumberField
      label={label}
      value={altitude.convert(value_ft)}
      minimum={altitude.convert(range[0])}
      maximum={altitude.convert(range[1])}
      step={10}
      format={(value) => value.toFixed(0)}
      unit={altitude.label}
      disabledReason={fixed}
      onCommit={(shown) => onCommit(within(altitude.revert(shown)))}
    />
  );
}

/** The corners: put on the map, taken back, and saved for everybody. */
function Border() {
  const { t } = useTranslation();
  const crossing = useCrossing();
  const isMarking = useMapTool(({ tool }) => tool === "fence");
  const count = useSurroundings((state) => state.corners.present.length);
  const saved = useSurroundings(isSaved);
  return (
    <>
      <p role="status">
        {t("map.around.corners", { count })}
        {!saved && <strong className="map-around-unsaved"> {t("map.around.unsaved")}</strong>}
      </p>
      {crossing !== undefined && <Notice level="error">{crossing}</Notice>}
      <div className="map-plan-buttons">
        <PutCorners isMarking={isMarking} />
        <ChangeCorners />
        <SaveCorners />
      </div>
      {isMarking && <p className="map-plan-hint">{t("map.around.markHint")}</p>}
      <OneCorner />
      <FenceFiles />
    </>
  );
}

const ICON = { size: 14, "aria-hidden": true } as const;

function PutCorners({ isMarking }: { isMarking: boolean }) {
  const { t } = useTranslation();
  const { edit } = usePart(SURROUNDINGS);
  const mapTool = usePart(MAP_TOOL);
  const tools = useScreenTools();
  const corners = useSurroundings((state) => state.corners.present);
  const fixed = useFixed();
  const full = corners.length >= MOST_CORNERS ? t("map.around.full", { most: MOST_CORNERS }) : undefined;
  const missing = fixed ?? (tools === null ? t("map.view.loading") : full);
  return (
    <>
      <Button
        pressed={isMarking}
        onPress={() => chooseTool(mapTool, isMarking ? "pick" : "fence")}
        icon={<Spline {...ICON} />}
        disabledReason={missing}
      >
        {t("map.around.mark")}
      </Button>
      <Button
        onPress={() => {
          const place = tools?.centre() ?? null;
          if (place !== null) {
            const { latitude_deg, longitude_deg } = place;
            edit([...corners, { latitude_deg, longitude_deg }]);
          }
        }}
        icon={<Crosshair {...ICON} />}
        disabledReason={missing}
      >
        {t("map.around.cornerHere")}
      </Button>
    </>
  );
}

function ChangeCorners() {
  const { t } = useTranslation();
  const { edit, undo, redo } = usePart(SURROUNDINGS);
  const { past, present, future } = useSurroundings((state) => state.corners);
  const fixed = useFixed();
  return (
    <>
      <Button
        onPress={undo}
        icon={<Undo2 {...ICON} />}
        label={t("map.around.undo")}
        disabledReason={fixed ?? (past.length === 0 ? t("plans.noUndo") : undefined)}
      >
        {null}
      </Button>
      <Button
        onPress={redo}
        icon={<Redo2 {...ICON} />}
        label={t("map.around.redo")}
        disabledReason={fixed ?? (future.length === 0 ? t("plans.noRedo") : undefined)}
      >
        {null}
      </Button>
      <Button
        onPress={() => edit([])}
        icon={<Trash2 {...ICON} />}
        label={t("map.around.clear")}
        disabledReason={fixed ?? (present.length === 0 ? t("map.around.noCorners") : undefined)}
      >
        {null}
      </Button>
    </>
  );
}

function SaveCorners() {
  const { t } = useTranslation();
  const { save } = usePart(SURROUNDINGS);
  const mapTool = usePart(MAP_TOOL);
  const count = useSurroundings((state) => state.corners.present.length);
  const saved = useSurroundings(isSaved);
  const fixed = useFixed();
  const crossing = useCrossing();
  const few = count > 0 && count < LEAST_CORNERS ? t("map.around.few") : undefined;
  return (
    <Button
      onPress={() => {
        chooseTool(mapTool, "pick");
        void save();
      }}
      icon={<Save {...ICON} />}
      disabledReason={fixed ?? few ?? crossing ?? (saved ? t("map.around.saved") : undefined)}
    >
      {t("map.around.save")}
    </Button>
  );
}

/** Why the drawn border encloses nothing certain; undefined if none of its sides cross. */
function useCrossing(): string | undefined {
  const { t } = useTranslation();
  const corners = useSurroundings((state) => state.corners.present);
  return useMemo(() => {
    const sides = crossingSides(corners);
    return sides === null
      ? undefined
      : t("map.around.crosses", { first: sides[0] + 1, second: sides[1] + 1 });
  }, [corners, t]);
}
