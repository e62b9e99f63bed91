import { ChevronDown, ChevronUp } from "lucide-react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../lib/aircraft";
import { HeightFigure, WindFigure } from "../../readouts/AirFigures";
import { useFlownAircraft } from "../../readouts/flownAircraft";
import { LiveReadout, type ReadoutRow } from "../../readouts/LiveReadout";
import { VOLTAGE } from "../../readouts/notations";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { ReadoutGrid } from "../../ui/Readout";
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
  const aircraft = useFlownAircraft();
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
