import { useCallback, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { PlanSketch, type PlanSketchHandle } from "../../instruments/plan/PlanSketch";
import { distance_m, type Position } from "../../lib/geodesy";
import type { Waypoint } from "../../lib/plan";
import type { PlanName } from "../../protocol/missions";
import { useUnit } from "../../readouts/useUnit";
import { useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";

interface Props {
  plan: PlanName;
  waypoints: readonly Waypoint[];
  active: number | null;
  selected: number | null;
  onSelect: (index: number) => void;
}

/** The aircraft is not drawn if it is farther than this from every waypoint: the plan would shrink to a dot. */
const NEAR_M = 60_000;
/**
 * The picture's extent grows in steps of a hundredth of a degree, so that it does not change with every metre flown.
 */
const STEPS = 100;

/** The sketch of a plan with the aircraft that flies it, while its position is live. */
export function LiveSketch({ plan, waypoints, active, selected, onSelect }: Props) {
  const { t } = useTranslation();
  const distance = useUnit("distance");
  const sketch = useRef<PlanSketchHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const place = placeOf(telemetry, plan, now_ms);
      sketch.current?.paintAircraft(
        place !== null && isNear(place, waypoints) ? place : null,
        headingOf(telemetry, plan, now_ms),
      );
    },
    [plan, waypoints],
  );
  usePaint("movement", paint);
  const coarse = useTelemetry((telemetry, now_ms) => coarseOf(placeOf(telemetry, plan, now_ms)));
  const aircraft = useMemo(() => {
    const place = coarse === "" ? null : placeFrom(coarse);
    return place !== null && isNear(place, waypoints) ? place : null;
  }, [coarse, waypoints]);
  return (
    <PlanSketch
      ref={sketch}
      label={t("plans.sketch", { count: waypoints.length })}
      waypoints={waypoints}
      active={active}
      selected={selected}
      onSelect={onSelect}
      aircraft={aircraft}
      north={t("plans.north")}
      formatLength={(length_m) => `${shortLength(distance.convert(length_m))} ${distance.label}`}
    />
  );
}

/** The position of a plan's aircraft: the simulator's for the HIL plan, the GPS's for the other. */
function placeOf(telemetry: TelemetryStore, plan: PlanName, now_ms: number): Position | null {
  const [latitude_deg, longitude_deg] =
    plan === "hil"
      ? [
          telemetry.liveNumber("simulator", "latitude_deg", now_ms),
          telemetry.liveNumber("simulator", "longitude_deg", now_ms),
        ]
      : [
          telemetry.liveNumber("gps", "latitude_deg", now_ms),
          telemetry.liveNumber("gps", "longitude_deg", now_ms),
        ];
  return latitude_deg === null || longitude_deg === null ? null : { latitude_deg, longitude_deg };
}

function headingOf(telemetry: TelemetryStore, plan: PlanName, now_ms: number): number | null {
  return plan === "hil"
    ? telemetry.liveNumber("simulator", "true_heading_deg", now_ms)
    : telemetry.liveNumber("gps", "heading_deg", now_ms);
}

function isNear(place: Position, waypoints: readonly Waypoint[]): boolean {
  return waypoints.some((waypoint) => distance_m(place, waypoint) < NEAR_M);
}

function coarseOf(place: Position | null): string {
  return place === null
    ? ""
    : `${Math.round(place.latitude_deg * STEPS)},${Math.round(place.longitude_deg * STEPS)}`;
}

function placeFrom(coarse: string): Position {
  const [latitude = 0, longitude = 0] = coarse.split(",").map(Number);
  return { latitude_deg: latitude / STEPS, longitude_deg: longitude / STEPS };
}

/** At most three digits: the lengths are round in metres, but not in miles. */
function shortLength(length: number): string {
  return String(Number(length.toPrecision(3)));
}
