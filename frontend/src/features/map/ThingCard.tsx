import { X } from "lucide-react";
import { type ReactNode, useCallback, useEffect, useId, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatHeading } from "../../lib/format";
import { bearing_deg, distance_m, type Position } from "../../lib/geodesy";
import type { MapThing, Whose } from "../../lib/mapThing";
import { captureRadius_m, unsentOf } from "../../lib/plan";
import { coordinate, heading, tenths, whole } from "../../readouts/formats";
import { LiveReadout } from "../../readouts/LiveReadout";
import { LiveBadge } from "../../readouts/StreamPanel";
import { useUnit } from "../../readouts/useUnit";
import { usePart } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Readout, ReadoutGrid, type ReadoutHandle } from "../../ui/Readout";
import { useWords } from "../../ui/words";
import { MAP_SELECTION, selectThing } from "./mapSelection";
import { aircraftPlace, PLACE_TOPIC } from "./plan/aircraftPlace";
import { useHome } from "./plan/useHome";
import { useMapPlan } from "./plan/useMapPlan";
import { useMapThing } from "./useMapThing";
import "./plan/card.css";

/** The values of what is chosen on the map, over its corner. Escape closes it. */
export function ThingCard() {
  const thing = useMapThing();
  return thing === null ? null : <Card thing={thing} />;
}

function Card({ thing }: { thing: MapThing }) {
  const mapSelection = usePart(MAP_SELECTION);
  const words = useWords();
  const title = useId();
  const close = useCallback(() => selectThing(mapSelection, null), [mapSelection]);
  useEffect(() => {
    const press = (event: KeyboardEvent): void => {
      // One that something else has taken, an edit or a window, is not for the card.
      if (
        event.key === "Escape" &&
        !event.defaultPrevented &&
        document.querySelector("[role=dialog]") === null
      ) {
        close();
      }
    };
    window.addEventListener("keydown", press);
    return () => window.removeEventListener("keydown", press);
  }, [close]);
  return (
    <section className="map-card" aria-labelledby={title}>
      <header>
        <h3 id={title}>
          <Title thing={thing} />
        </h3>
        <button type="button" aria-label={words.close} onClick={close}>
          <X size={14} aria-hidden="true" />
        </button>
      </header>
      <Values thing={thing} />
    </section>
  );
}

function Title({ thing }: { thing: MapThing }) {
  const { t } = useTranslation();
  switch (thing.kind) {
    case "home":
      return t("map.plan.home");
    case "aircraft":
      return thing.plan === "flight" ? t("map.plan.aircraftFlight") : t("map.plan.aircraftHil");
    case "waypoint":
      return `${t("map.plan.editing", { number: thing.row + 1 })} · ${t(`planName.${thing.plan}`)}`;
  }
}

function Values({ thing }: { thing: MapThing }): ReactNode {
  switch (thing.kind) {
    case "home":
      return <HomeValues />;
    case "aircraft":
      return thing.plan === "flight" ? <FlightValues /> : <HilValues />;
    case "waypoint":
      return <WaypointValues plan={thing.plan} row={thing.row} />;
  }
}

function FlightValues() {
  const { t } = useTranslation();
  return (
    <>
      <LiveBadge topic="gps" />
      <ReadoutGrid columns={1}>
        <LiveReadout
          topic="gps"
          field="latitude_deg"
          format={coordinate}
          label={t("plans.latitude")}
          unit={t("unit.deg")}
          chars={10}
        />
        <LiveReadout
          topic="gps"
          field="longitude_deg"
          format={coordinate}
          label={t("plans.longitude")}
          unit={t("unit.deg")}
          chars={10}
        />
        <LiveReadout topic="gps" field="altitude_m" quantity="altitude" label={t("plans.altitude")} />
        <LiveReadout topic="gps" field="speed_kt" quantity="speed" label={t("plans.speed")} />
        <LiveReadout
          topic="gps"
          field="heading_deg"
          format={heading}
          label={t("map.plan.course")}
          unit={t("unit.deg")}
        />
        <LiveReadout topic="gps" field="satellites" format={whole} label={t("map.plan.satellites")} />
      </ReadoutGrid>
      <LiveBadge topic="ahrs" />
      <ReadoutGrid columns={1}>
        <LiveReadout
          topic="ahrs"
          field="yaw_deg"
          format={heading}
          label={t("map.plan.heading")}
          unit={t("unit.deg")}
          chars={5}
        />
        <LiveReadout
          topic="ahrs"
          field="pitch_deg"
          format={tenths}
          label={t("map.plan.pitch")}
          unit={t("unit.deg")}
          chars={5}
        />
        <LiveReadout
          topic="ahrs"
          field="roll_deg"
          format={tenths}
          label={t("map.plan.roll")}
          unit={t("unit.deg")}
          chars={5}
        />
      </ReadoutGrid>
    </>
  );
}

function HilValues() {
  const { t } = useTranslation();
  return (
    <>
      <LiveBadge topic="simulator" />
      <ReadoutGrid columns={1}>
        <LiveReadout
          topic="simulator"
          field="latitude_deg"
          format={coordinate}
          label={t("plans.latitude")}
          unit={t("unit.deg")}
          chars={10}
        />
        <LiveReadout
          topic="simulator"
          field="longitude_deg"
          format={coordinate}
          label={t("plans.longitude")}
          unit={t("unit.deg")}
          chars={10}
        />
        <LiveReadout
          topic="simulator"
          field="altitude_msl_ft"
          quantity="altitude"
          label={t("plans.altitude")}
        />
        <LiveReadout
          topic="simulator"
          field="indicated_airspeed_kt"
          quantity="speed"
          label={t("plans.speed")}
        />
        <LiveReadout
          topic="simulator"
          field="horizontal_path_deg"
          format={heading}
          label={t("map.plan.course")}
          unit={t("unit.deg")}
        />
        <LiveReadout
          topic="simulator"
          field="vvi_ft_min"
          quantity="verticalSpeed"
          label={t("map.plan.climb")}
        />
      </ReadoutGrid>
      <ReadoutGrid columns={1}>
        <LiveReadout
          topic="simulator"
          field="true_heading_deg"
          format={heading}
          label={t("map.plan.heading")}
          unit={t("unit.deg")}
          chars={5}
        />
        <LiveReadout
          topic="simulator"
          field="pitch_deg"
          format={tenths}
          label={t("map.plan.pitch")}
          unit={t("unit.deg")}
          chars={5}
        />
        <LiveReadout
          topic="simulator"
          field="roll_deg"
          format={tenths}
          label={t("map.plan.roll")}
          unit={t("unit.deg")}
          chars={5}
        />
      </ReadoutGrid>
    </>
  );
}

function HomeValues() {
  const { t } = useTranslation();
  const home = useHome();
  const source = {
    first: t("map.plan.homeFirst"),
    firstHil: t("map.plan.homeFirstHil"),
    runway: t("map.plan.homeRunway"),
  }[home.source];
  return (
    <>
      <p className="map-card-note">{source}</p>
      <dl className="map-card-facts">
        <Fact label={t("plans.latitude")} text={`${coordinate(home.latitude_deg)}${t("unit.deg")}`} />
        <Fact label={t("plans.longitude")} text={`${coordinate(home.longitude_deg)}${t("unit.deg")}`} />
      </dl>
      <FromAircraft whose="flight" to={home} />
      <FromAircraft whose="hil" to={home} />
    </>
  );
}

function WaypointValues({ plan, row }: { plan: Whose; row: number }) {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const speed = useUnit("speed");
  const distance = useUnit("distance");
  const { waypoints, onBoard, flownTo } = useMapPlan(plan);
  const waypoint = waypoints[row];
  if (waypoint === undefined) {
    return <p className="map-card-note">{t("map.plan.gone")}</p>;
  }
  const isUnsent = unsentOf(waypoints, onBoard)[row] === true;
  const next = waypoints[row + 1];
  return (
    <>
      <p className="map-card-note" data-unsent={isUnsent}>
        {isUnsent
          ? onBoard === null
            ? t("planState.unknown")
            : t("map.plan.unsent")
          : row === flownTo
            ? t("map.plan.flown")
            : t("map.plan.sent")}
      </p>
      <dl className="map-card-facts">
        <Fact label={t("plans.latitude")} text={`${coordinate(waypoint.latitude_deg)}${t("unit.deg")}`} />
        <Fact label={t("plans.longitude")} text={`${coordinate(waypoint.longitude_deg)}${t("unit.deg")}`} />
        <Fact
          label={t("plans.altitude")}
          text={`${altitude.format(waypoint.altitude_ft)} ${altitude.label}`}
        />
        <Fact label={t("plans.speed")} text={`${speed.format(waypoint.speed_kt)} ${speed.label}`} />
        <Fact
          label={t("map.plan.capture")}
          text={`${distance.format(captureRadius_m(waypoint.speed_kt))} ${distance.label}`}
        />
        {next !== undefined && (
          <Fact
            label={t("plans.toNext")}
            text={`${distance.format(distance_m(waypoint, next))} ${distance.label} · ${formatHeading(bearing_deg(waypoint, next), 0) ?? t("words.dash")}${t("unit.deg")}`}
          />
        )}
      </dl>
      <FromAircraft whose={plan} to={waypoint} />
    </>
  );
}

/** How far, and in which direction, the place is from an aircraft: as live as the aircraft's own place. */
function FromAircraft({ whose, to }: { whose: Whose; to: Position }) {
  const { t } = useTranslation();
  const unit = useUnit("distance");
  const away = useRef<ReadoutHandle>(null);
  const bearing = useRef<ReadoutHandle>(null);
  const { latitude_deg, longitude_deg } = to;
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const from = aircraftPlace(telemetry, whose);
      const place = { latitude_deg, longitude_deg };
      const state = telemetry.state(PLACE_TOPIC[whose], now_ms);
      away.current?.paint(from === null ? null : unit.format(distance_m(from, place)), state);
      bearing.current?.paint(from === null ? null : heading(bearing_deg(from, place)), state);
    },
    [whose, latitude_deg, longitude_deg, unit],
  );
  usePaint("text", paint);
  const name = whose === "flight" ? t("map.plan.fromFlight") : t("map.plan.fromHil");
  return (
    <ReadoutGrid columns={1}>
      <Readout ref={away} label={name} unit={unit.label} />
      <Readout ref={bearing} label={t("plans.bearing")} unit={t("unit.deg")} />
    </ReadoutGrid>
  );
}

function Fact({ label, text }: { label: string; text: string }) {
  return (
    <div>
      <dt>{label}</dt>
      <dd>{text}</dd>
    </div>
  );
}
