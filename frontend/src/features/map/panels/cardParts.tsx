import type { ParseKeys } from "i18next";
import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { bearing_deg, distance_m, type Position } from "../../../lib/geodesy";
import { coordinate, heading } from "../../../readouts/formats";
import { useUnit } from "../../../readouts/useUnit";
import type { TelemetryStore } from "../../../store/telemetry";
import { usePaint } from "../../../store/usePaint";
import { Readout, ReadoutGrid, type ReadoutHandle } from "../../../ui/Readout";
import { aircraftPlace, PLACE_TOPIC } from "../aircraft/aircraftPlace";

export type Fact = readonly [label: ParseKeys, text: string];

/** Position and other facts that come from no stream. */
export function Facts({ place, more = [] }: { place: Position; more?: readonly Fact[] }) {
  const { t } = useTranslation();
  const facts: readonly Fact[] = [
    ["plans.latitude", `${coordinate(place.latitude_deg)}${t("unit.deg")}`],
    ["plans.longitude", `${coordinate(place.longitude_deg)}${t("unit.deg")}`],
    ...more,
  ];
  return (
    <dl className="map-card-facts">
      {facts.map(([label, text]) => (
        <div key={label}>
          <dt>{t(label)}</dt>
          <dd>{text}</dd>
        </div>
      ))}
    </dl>
  );
}

/** Distance and bearing of the place from an aircraft; stale when the aircraft's position is. */
export function FromAircraft({ aircraft, to }: { aircraft: Aircraft; to: Position }) {
  const { t } = useTranslation();
  const unit = useUnit("distance");
  const away = useRef<ReadoutHandle>(null);
  const bearing = useRef<ReadoutHandle>(null);
  const { latitude_deg, longitude_deg } = to;
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const from = aircraftPlace(telemetry, aircraft);
      const place = { latitude_deg, longitude_deg };
      const state = telemetry.state(PLACE_TOPIC[aircraft], now_ms);
      away.current?.paint(from === null ? null : unit.format(distance_m(from, place)), state);
      bearing.current?.paint(from === null ? null : heading(bearing_deg(from, place)), state);
    },
    [aircraft, latitude_deg, longitude_deg, unit],
  );
  usePaint("text", paint);
  const name = aircraft === "flight" ? t("map.plan.fromFlight") : t("map.plan.fromHil");
  return (
    <ReadoutGrid columns={1}>
      <Readout ref={away} label={name} unit={unit.label} />
      <Readout ref={bearing} label={t("plans.bearing")} unit={t("unit.deg")} />
    </ReadoutGrid>
  );
}
