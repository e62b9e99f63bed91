import { ChevronDown, ChevronUp } from "lucide-react";
import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../lib/aircraft";
import { formatHeading } from "../../lib/format";
import { windNow } from "../../missions/useWind";
import { LiveReadout, type ReadoutRow } from "../../readouts/LiveReadout";
import { VOLTAGE } from "../../readouts/notations";
import { useUnit } from "../../readouts/useUnit";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Button } from "../../ui/Button";
import { Readout, ReadoutGrid, type ReadoutHandle } from "../../ui/Readout";
import { useFollowed } from "./aircraft/useFlightScene";
import "./figures.css";

const FOLD = "map.fold.figures";

type Row = Pick<ReadoutRow, "field" | "label" | "as"> & { readonly topic: Topic };
type Topic = "gps" | "analog" | "simulator" | "fms_plan" | "fms_hil_plan";

/** The few figures that one flies by over the map: of each aircraft what it sends. */
const FIGURES: Readonly<Record<Aircraft, readonly Row[]>> = {
  flight: [
    { topic: "analog", field: "calibrated_airspeed_kt", label: "map.figures.speed", as: "speed" },
    { topic: "gps", field: "altitude_m", label: "map.figures.altitude", as: "altitude" },
    { topic: "fms_plan", field: "distance_m", label: "map.figures.toWaypoint", as: "distance" },
    { topic: "analog", field: "battery_v", label: "map.figures.battery", as: VOLTAGE },
  ],
  hil: [
    { topic: "simulator", field: "indicated_airspeed_kt", label: "map.figures.speed", as: "speed" },
    { topic: "simulator", field: "altitude_msl_ft", label: "map.figures.altitude", as: "altitude" },
    { topic: "fms_hil_plan", field: "distance_m", label: "map.figures.toWaypoint", as: "distance" },
  ],
};

/** Over the map: speed, altitude, way to the waypoint, battery and wind of the aircraft that is followed. */
export function FlightFigures() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const aircraft = useFollowed();
  const isFolded = useSettings(({ choices }) => choices[FOLD] === "yes");
  const name = aircraft === "flight" ? t("map.view.flight") : t("map.view.hil");
  const Icon = isFolded ? ChevronUp : ChevronDown;
  return (
    <section className="map-figures" aria-label={t("map.figures.title", { name })}>
      <Button
        onPress={() => choose(settings, FOLD, isFolded ? "no" : "yes")}
        icon={<Icon size={14} aria-hidden="true" />}
        label={isFolded ? t("map.figures.open") : t("map.figures.close")}
      >
        {null}
      </Button>
      {!isFolded && (
        <ReadoutGrid columns={1} className="map-figures-list">
          {FIGURES[aircraft].map((row) => (
            <LiveReadout key={`${row.topic} ${row.field}`} {...row} chars={5} />
          ))}
          <HeightFigure aircraft={aircraft} />
          {aircraft === "flight" && <WindFigure />}
        </ReadoutGrid>
      )}
    </section>
  );
}

/** Height above the ground, where the station knows the ground and the position is live. */
function HeightFigure({ aircraft }: { aircraft: Aircraft }) {
  const { t } = useTranslation();
  const { connection } = usePage();
  const altitude = useUnit("altitude");
  const readout = useRef<ReadoutHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const isLive = telemetry.state(aircraft === "flight" ? "gps" : "simulator", now_ms) === "live";
      const height_ft = connection.getState().status?.surroundings[aircraft].height_ft ?? null;
      const shown = isLive ? height_ft : null;
      readout.current?.paint(
        shown === null ? null : altitude.format(shown),
        shown === null ? "none" : "live",
      );
    },
    [connection, altitude, aircraft],
  );
  usePaint("text", paint);
  return <Readout ref={readout} label={t("map.figures.height")} unit={altitude.label} chars={5} />;
}

/** The wind that the real aircraft's values imply now; without all of them there is none. */
function WindFigure() {
  const { t } = useTranslation();
  const speed = useUnit("speed");
  const readout = useRef<ReadoutHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const wind = windNow(telemetry, "flight", now_ms);
      const text =
        wind === null ? null : `${formatHeading(wind.from_deg, 0)}° ${speed.format(wind.speed_kt)}`;
      readout.current?.paint(text, wind === null ? "none" : "live");
    },
    [speed],
  );
  usePaint("text", paint);
  return <Readout ref={readout} label={t("map.figures.wind")} unit={speed.label} chars={8} />;
}
