import { X } from "lucide-react";
import { type ReactNode, useCallback, useEffect, useId } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft, MapThing } from "../../lib/aircraft";
import { formatHeading } from "../../lib/format";
import { bearing_deg, distance_m } from "../../lib/geodesy";
import { captureRadius_m, unsentOf } from "../../lib/plan";
import { SELECTION, selectThing, useMapThing } from "../../missions/selection";
import type { ReadoutRow, ReadoutRows } from "../../readouts/LiveReadout";
import { ANGLE, COORDINATE, COUNT, HEADING } from "../../readouts/notations";
import { ReadoutTable } from "../../readouts/ReadoutTable";
import { LiveBadge } from "../../readouts/StreamPanel";
import { type Unit, useUnit } from "../../readouts/useUnit";
import { usePart } from "../../store/hooks";
import { useWords } from "../../ui/words";
import { useHome } from "./aircraft/useHome";
import { AirfieldValues } from "./airfields/AirfieldValues";
import { type Fact, Facts, FromAircraft } from "./panels/cardParts";
import { useMapPlan } from "./plan/useMapPlan";
import { useMapTool } from "./tools/mapTool";
import "./panels/card.css";

/** A card with the values of what is selected on the map. Escape closes it. */
export function ThingCard() {
  const thing = useMapThing();
  // While points are added the map is needed, not what was added last.
  const isAdding = useMapTool(({ tool }) => tool === "add");
  return thing === null || isAdding ? null : <Card thing={thing} />;
}

function Card({ thing }: { thing: MapThing }) {
  const selection = usePart(SELECTION);
  const words = useWords();
  const title = useId();
  const close = useCallback(() => selectThing(selection, null), [selection]);
  useEffect(() => {
    const press = (event: KeyboardEvent): void => {
      // Not for the card: an edit or a dialog has handled the key.
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
    case "airfield":
      return thing.code;
    case "waypoint":
      return `${t("map.plan.editing", { number: thing.row + 1 })} · ${t(`planName.${thing.plan}`)}`;
  }
}

function Values({ thing }: { thing: MapThing }): ReactNode {
  switch (thing.kind) {
    case "home":
      return <HomeValues />;
    case "aircraft":
      return <AircraftValues aircraft={thing.plan} />;
    case "airfield":
      return <AirfieldValues {...thing} />;
    case "waypoint":
      return <WaypointValues plan={thing.plan} row={thing.row} />;
  }
}

const PITCH_ROLL: ReadonlyArray<ReadoutRow<"pitch_deg" | "roll_deg">> = [
  { field: "pitch_deg", label: "map.plan.pitch", as: ANGLE },
  { field: "roll_deg", label: "map.plan.roll", as: ANGLE },
];

const FLIGHT_PLACE: ReadoutRows = {
  topic: "gps",
  rows: [
    { field: "latitude_deg", label: "plans.latitude", as: COORDINATE, chars: 10 },
    { field: "longitude_deg", label: "plans.longitude", as: COORDINATE, chars: 10 },
    { field: "altitude_m", label: "plans.altitude", as: "altitude" },
    { field: "speed_kt", label: "plans.speed", as: "speed" },
    { field: "heading_deg", label: "map.plan.course", as: HEADING },
    { field: "satellites", label: "map.plan.satellites", as: COUNT },
  ],
};

const FLIGHT_ATTITUDE: ReadoutRows = {
  topic: "ahrs",
  rows: [{ field: "yaw_deg", label: "map.plan.heading", as: HEADING }, ...PITCH_ROLL],
};

const HIL_PLACE: ReadoutRows = {
  topic: "simulator",
  rows: [
    { field: "latitude_deg", label: "plans.latitude", as: COORDINATE, chars: 10 },
    { field: "longitude_deg", label: "plans.longitude", as: COORDINATE, chars: 10 },
    { field: "altitude_msl_ft", label: "plans.altitude", as: "altitude" },
    { field: "indicated_airspeed_kt", label: "plans.speed", as: "speed" },
    { field: "horizontal_path_deg", label: "map.plan.course", as: HEADING },
    { field: "vvi_ft_min", label: "map.plan.climb", as: "verticalSpeed" },
  ],
};

const HIL_ATTITUDE: ReadoutRows = {
  topic: "simulator",
  rows: [{ field: "true_heading_deg", label: "map.plan.heading", as: HEADING }, ...PITCH_ROLL],
};

function AircraftValues({ aircraft }: { aircraft: Aircraft }) {
  return aircraft === "flight" ? (
    <>
      <LiveBadge topic="gps" />
      <ReadoutTable {...FLIGHT_PLACE} />
      <LiveBadge topic="ahrs" />
      <ReadoutTable {...FLIGHT_ATTITUDE} chars={5} />
    </>
  ) : (
    <>
      <LiveBadge topic="simulator" />
      <ReadoutTable {...HIL_PLACE} />
      <ReadoutTable {...HIL_ATTITUDE} chars={5} />
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
      <Facts place={home} />
      <FromAircraft aircraft="flight" to={home} />
      <FromAircraft aircraft="hil" to={home} />
    </>
  );
}

function WaypointValues({ plan, row }: { plan: Aircraft; row: number }) {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const speed = useUnit("speed");
  const distance = useUnit("distance");
  const { waypoints, onBoard, flownTo } = useMapPlan(plan);
  const waypoint = waypoints[row];
  if (waypoint === undefined) {
    return <p className="map-card-note">{t("map.plan.gone")}</p>;
  }
  const written = (value: number, unit: Unit): string => `${unit.format(value)} ${unit.label}`;
  const isUnsent = unsentOf(waypoints, onBoard)[row] === true;
  const next = waypoints[row + 1];
  const facts: Fact[] = [
    ["plans.altitude", written(waypoint.altitude_ft, altitude)],
    ["plans.speed", written(waypoint.speed_kt, speed)],
    ["map.plan.capture", written(captureRadius_m(waypoint.speed_kt), distance)],
  ];
  if (next !== undefined) {
    const bearing = formatHeading(bearing_deg(waypoint, next), 0) ?? t("words.dash");
    facts.push([
      "plans.toNext",
      `${written(distance_m(waypoint, next), distance)} · ${bearing}${t("unit.deg")}`,
    ]);
  }
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
      <Facts place={waypoint} more={facts} />
      <FromAircraft aircraft={plan} to={waypoint} />
    </>
  );
}
