import { ArrowDown, ArrowLeft, ArrowRight, ArrowUp, ChevronsDown, ChevronsUp } from "lucide-react";
import { type KeyboardEvent, type ReactNode, useId } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { changed, type Push, pushed, type Waypoint, type WaypointField } from "../../../lib/plan";
import { useOriginText } from "../../../missions/altitudeOrigin";
import { PlaceField } from "../../../missions/PlaceField";
import { amendPlan, editPlan, MISSIONS, redoPlan, undoPlan } from "../../../missions/planDrafts";
import { COLUMN } from "../../../missions/planFacts";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { type Unit, useUnit } from "../../../readouts/useUnit";
import { usePage, usePart } from "../../../store/hooks";
import { choose } from "../../../store/settings";
import { NumberField } from "../../../ui/NumberField";
import { SegmentedSwitch } from "../../../ui/SegmentedSwitch";
import { useFlat } from "../scenes/useFlat";
import type { HeldWaypoint } from "./usePlanScene";
import { STEP_CHOICE, STEPS, type Step, useStepChoice } from "./useStep";

interface Props {
  aircraft: Aircraft;
  waypoints: readonly Waypoint[];
  row: number;
  /** Where the pointer drags it; null if it is not being dragged. */
  held: HeldWaypoint["to"] | null;
}

const KEYS: Readonly<Record<string, (step: number) => Push>> = {
  ArrowUp: (north_m) => ({ north_m }),
  ArrowDown: (step) => ({ north_m: -step }),
  ArrowRight: (east_m) => ({ east_m }),
  ArrowLeft: (step) => ({ east_m: -step }),
  PageUp: (up_ft) => ({ up_ft }),
  PageDown: (step) => ({ up_ft: -step }),
};

/** The selected waypoint: number fields, and buttons that move it. */
export function WaypointEditor({ aircraft, waypoints, row, held }: Props) {
  const { t } = useTranslation();
  const waypoint = waypoints[row];
  const originText = useOriginText(aircraft);
  const origin = waypoint === undefined ? null : originText({ ...waypoint, ...held });
  return waypoint === undefined ? null : (
    <fieldset className="map-plan-editor">
      <legend>{t("map.plan.editing", { number: row + 1 })}</legend>
      <Fields aircraft={aircraft} waypoints={waypoints} row={row} waypoint={{ ...waypoint, ...held }} />
      {origin !== null && <p className="map-plan-hint">{origin}</p>}
      <Pusher aircraft={aircraft} waypoints={waypoints} row={row} />
    </fieldset>
  );
}

function Fields({ aircraft, waypoints, row, waypoint }: Omit<Props, "held"> & { waypoint: Waypoint }) {
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const altitude = useUnit("altitude");
  const speed = useUnit("speed");

  function field(name: WaypointField, step: number, digits: number, unit: Unit | null): ReactNode {
    const { minimum, maximum } = PLAN_LIMITS.fields[name];
    const shown = (value: number): number => (unit === null ? value : unit.convert(value));
    return (
      <NumberField
        label={t(`plans.${COLUMN[name]}`)}
        value={shown(waypoint[name])}
        minimum={shown(minimum)}
        maximum={shown(maximum)}
        step={step}
        format={(value) => value.toFixed(digits)}
        unit={unit === null ? t("unit.deg") : unit.label}
        subject={waypoints[row]}
        onCommit={(value) =>
          editPlan(
            missions.plans,
            aircraft,
            changed(waypoints, row, name, unit === null ? value : unit.revert(value)),
          )
        }
      />
    );
  }

  return (
    <div className="map-plan-fields">
      <PlaceField
        place={waypoint}
        fixed={undefined}
        onCommit={(place) =>
          editPlan(missions.plans, aircraft, waypoints.with(row, { ...waypoint, ...place }))
        }
      />
      {field("latitude_deg", 0.0001, 6, null)}
      {field("longitude_deg", 0.0001, 6, null)}
      {field("altitude_ft", 10, altitude.digits, altitude)}
      {field("speed_kt", 1, speed.digits, speed)}
    </div>
  );
}

/** Buttons to move the waypoint; their keys work while anything in here has the focus. */
function Pusher({ aircraft, waypoints, row }: Omit<Props, "held">) {
  const { t } = useTranslation();
  const flat = useFlat();
  const { settings } = usePage();
  const missions = usePart(MISSIONS);
  const hint = useId();
  const step = useStepChoice();

  function push(by: Push, isRepeat: boolean): void {
    // The repeats of a held key are one step to the undo.
    const put = isRepeat ? amendPlan : editPlan;
    put(missions.plans, aircraft, pushed(waypoints, row, by));
  }

  const undoing: Readonly<Record<string, () => void>> = {
    z: () => undoPlan(missions.plans, aircraft),
    Z: () => redoPlan(missions.plans, aircraft),
    y: () => redoPlan(missions.plans, aircraft),
  };

  function onKeyDown(event: KeyboardEvent): void {
    const { altKey, ctrlKey, metaKey, key, repeat } = event;
    const by = ctrlKey || altKey || metaKey ? undefined : KEYS[key];
    const undo = ctrlKey ? undoing[key] : undefined;
    if (by !== undefined) push(by(STEPS[step]), repeat);
    else if (undo !== undefined) undo();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  const arrows = [
    { key: "ArrowUp", label: t("map.plan.north"), icon: <ArrowUp size={14} aria-hidden="true" /> },
    { key: "ArrowLeft", label: t("map.plan.west"), icon: <ArrowLeft size={14} aria-hidden="true" /> },
    { key: "ArrowRight", label: t("map.plan.east"), icon: <ArrowRight size={14} aria-hidden="true" /> },
    { key: "ArrowDown", label: t("map.plan.south"), icon: <ArrowDown size={14} aria-hidden="true" /> },
    { key: "PageUp", label: t("map.plan.up"), icon: <ChevronsUp size={14} aria-hidden="true" /> },
    { key: "PageDown", label: t("map.plan.down"), icon: <ChevronsDown size={14} aria-hidden="true" /> },
  ] as const;
  return (
    <div className="map-plan-pusher">
      <SegmentedSwitch
        label={t("map.plan.step")}
        options={(Object.keys(STEPS) as Step[]).map((value) => ({
          value,
          label: `${value} ${t("unit.m")} · ${value} ${t("unit.ft")}`,
        }))}
        value={step}
        onChange={(next) => choose(settings, STEP_CHOICE, next)}
      />
      {/* biome-ignore lint/a11y/useSemanticElements: a fieldset would say its name twice */}
      <div
        role="group"
        aria-label={t("map.plan.push")}
        aria-describedby={hint}
        className="map-plan-arrows"
        onKeyDown={onKeyDown}
      >
        {arrows.map(({ key, label, icon }) => (
          <button
            key={key}
            type="button"
            data-key={key}
            aria-label={label}
            title={label}
            onClick={() => push(KEYS[key]?.(STEPS[step]) ?? {}, false)}
          >
            {icon}
          </button>
        ))}
      </div>
      <p id={hint} className="map-plan-hint">
        {flat.isShown ? t("map.flat.pushHint") : t("map.plan.pushHint")}
      </p>
    </div>
  );
}
