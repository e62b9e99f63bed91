import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import type { Position } from "../../../lib/geodesy";
import { type Circuit, circuit, type RunwayEnd } from "../../../lib/planPatterns";
import { useUnit } from "../../../readouts/useUnit";
import { Button } from "../../../ui/Button";
import { SegmentedSwitch } from "../../../ui/SegmentedSwitch";
import { Select } from "../../../ui/Select";
import type { MapPlan } from "../plan/useMapPlan";
import { useScreenTools } from "../scenes/useScreenTools";
import { PatternButtons } from "./PatternButtons";
import { AngleField, HeightField, LengthField, SpeedField } from "./PatternFields";
import { RUNWAYS, useRunways } from "./runwayChoices";

/** The runway of one's own meadow, which no list has. */
const OWN = "own";
const OWN_LENGTH_M = 120;
const USUAL: Circuit = {
  side: "right",
  height_ft: 700,
  width_m: 900,
  upwind_m: 500,
  final_m: 1500,
  pass_ft: 200,
  speed_kt: 55,
};

/** An aerodrome circuit by runway: of an airfield that is known, or of a place on the map and a course. */
export function CircuitForm({ aircraft, plan }: { aircraft: Aircraft; plan: MapPlan }) {
  const { t } = useTranslation();
  const tools = useScreenTools();
  const altitude = useUnit("altitude");
  const [chosen, setChosen] = useState<string>(RUNWAYS[0]?.id ?? OWN);
  const { runways, looking, look } = useRunways();
  const [own, setOwn] = useState<Position | null>(null);
  const [course_deg, setCourse_deg] = useState(0);
  const [elevation_ft, setElevation_ft] = useState(0);
  const [wanted, setWanted] = useState<Circuit>(USUAL);
  const known = runways.find(({ id }) => id === chosen)?.runway;
  const runway: RunwayEnd | null =
    known ?? (own === null ? null : { threshold: own, course_deg, length_m: OWN_LENGTH_M, elevation_ft });
  const lookAround = async (): Promise<void> => {
    const centre = tools?.centre() ?? null;
    const [nearest] = centre === null ? [] : await look(centre);
    if (nearest !== undefined) setChosen(nearest.id);
  };
  const reading = looking === "reading" ? t("map.airfields.reading") : undefined;
  const busy = tools === null ? t("map.view.loading") : reading;
  const set = (part: Partial<Circuit>): void => setWanted({ ...wanted, ...part });
  return (
    <div className="map-plan-fields">
      <Select
        label={t("map.pattern.runway")}
        placeholder=""
        value={chosen}
        onChange={setChosen}
        options={[
          ...runways.map(({ id, name }) => ({ value: id, label: name })),
          { value: OWN, label: t("map.pattern.own") },
        ]}
      />
      <Button onPress={() => void lookAround()} disabledReason={busy}>
        {t("map.pattern.around")}
      </Button>
      <p className="map-plan-hint" role="status">
        {looking === "none" && t("map.pattern.aroundNone")}
        {looking === "failed" && t("map.pattern.aroundFailed")}
      </p>
      {known === undefined && (
        <>
          <Button
            onPress={() => setOwn(tools?.centre() ?? null)}
            disabledReason={tools === null ? t("map.view.loading") : undefined}
          >
            {t("map.pattern.ownHere")}
          </Button>
          <AngleField label={t("map.pattern.course")} value={course_deg} onCommit={setCourse_deg} />
          <HeightField
            label={t("map.pattern.elevation")}
            value={elevation_ft}
            minimum={-1000}
            maximum={15_000}
            onCommit={setElevation_ft}
          />
        </>
      )}
      <SegmentedSwitch
        label={t("map.pattern.side")}
        options={[
          { value: "left", label: t("map.pattern.left") },
          { value: "right", label: t("map.pattern.right") },
        ]}
        value={wanted.side}
        onChange={(side) => set({ side })}
      />
      <HeightField
        label={t("map.pattern.height")}
        value={wanted.height_ft}
        minimum={100}
        maximum={3000}
        onCommit={(height_ft) => set({ height_ft })}
      />
      <LengthField
        label={t("map.pattern.width")}
        value_m={wanted.width_m}
        minimum_m={250}
        maximum_m={5000}
        onCommit={(width_m) => set({ width_m })}
      />
      <LengthField
        label={t("map.pattern.final")}
        value_m={wanted.final_m}
        minimum_m={300}
        maximum_m={8000}
        onCommit={(final_m) => set({ final_m })}
      />
      <HeightField
        label={t("map.pattern.pass")}
        value={wanted.pass_ft}
        minimum={50}
        maximum={1000}
        onCommit={(pass_ft) => set({ pass_ft })}
      />
      <SpeedField value={wanted.speed_kt} onCommit={(speed_kt) => set({ speed_kt })} />
      <p className="map-plan-hint">
        {t("map.pattern.circuitHint", {
          height: `${altitude.format(wanted.pass_ft) ?? ""} ${altitude.label}`,
        })}
      </p>
      <PatternButtons
        aircraft={aircraft}
        plan={plan}
        pattern={runway === null ? null : circuit(runway, wanted)}
        missing={t("map.pattern.noRunway")}
      />
    </div>
  );
}
