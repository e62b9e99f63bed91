import { useTranslation } from "react-i18next";
import type { Waypoint } from "../../lib/plan";
import { METRES_PER_FOOT } from "../../lib/units";
import { useMapThing } from "../../missions/selection";
import type { PlaceInSpace } from "../../scene/tools/MapTools";
import { usePage, useTelemetry } from "../../store/hooks";
import { Select } from "../../ui/Select";
import { aircraftPlace, PLACE_TOPIC } from "./aircraft/aircraftPlace";
import { useHome } from "./aircraft/useHome";
import { useMapPlan } from "./plan/useMapPlan";
import { useLookAt } from "./useLookAt";

/** "Look at" for each thing on the map: aircraft, plans, home, and the waypoint that is selected. */
export function LookAt() {
  const { t } = useTranslation();
  const { telemetry } = usePage();
  const look = useLookAt();
  const home = useHome();
  const thing = useMapThing();
  const plans = { flight: useMapPlan("flight"), hil: useMapPlan("hil") };
  const flight = useTelemetry((from, now_ms) => from.state(PLACE_TOPIC.flight, now_ms));
  const hil = useTelemetry((from, now_ms) => from.state(PLACE_TOPIC.hil, now_ms));
  const waypoint = thing?.kind === "waypoint" ? plans[thing.plan].waypoints[thing.row] : undefined;
  const things: ReadonlyArray<{
    name: string;
    places: () => readonly PlaceInSpace[];
    isThere: boolean;
  }> = [
    {
      name: t("map.plan.aircraftFlight"),
      places: () => [aircraftPlace(telemetry, "flight")].filter((place) => place !== null),
      isThere: flight !== "none",
    },
    {
      name: t("map.plan.aircraftHil"),
      places: () => [aircraftPlace(telemetry, "hil")].filter((place) => place !== null),
      isThere: hil !== "none",
    },
    {
      name: t("map.plan.flight"),
      places: () => plans.flight.waypoints.map(inSpace),
      isThere: plans.flight.waypoints.length > 0,
    },
    {
      name: t("map.plan.hil"),
      places: () => plans.hil.waypoints.map(inSpace),
      isThere: plans.hil.waypoints.length > 0,
    },
    {
      name: t("map.look.waypoint"),
      places: () => (waypoint === undefined ? [] : [inSpace(waypoint)]),
      isThere: waypoint !== undefined,
    },
    { name: t("map.plan.home"), places: () => [{ ...home, altitude_m: 0 }], isThere: true },
  ];
  const offered = things.filter(({ isThere }) => isThere);
  return (
    <Select
      label={t("map.look.title")}
      placeholder={t("map.look.choose")}
      value={null}
      onChange={(name) => look(offered.find((one) => one.name === name)?.places() ?? [])}
      options={offered.map(({ name }) => ({ value: name, label: name }))}
    />
  );
}

function inSpace(waypoint: Waypoint): PlaceInSpace {
  return { ...waypoint, altitude_m: waypoint.altitude_ft * METRES_PER_FOOT };
}
