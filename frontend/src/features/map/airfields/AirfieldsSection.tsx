import { TowerControl } from "lucide-react";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatHeading } from "../../../lib/format";
import { bearing_deg, distance_m, type Position } from "../../../lib/geodesy";
import { SELECTION, selectThing, useMapThing } from "../../../missions/selection";
import { useFlownAircraft } from "../../../readouts/flownAircraft";
import { useUnit } from "../../../readouts/useUnit";
import type { NearAirfield } from "../../../scene/world/things";
import { keptWorld } from "../../../scene/world/World";
import { usePart, useTelemetry } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { Panel } from "../../../ui/Panel";
import { aircraftPlace } from "../aircraft/aircraftPlace";
import { useHome } from "../aircraft/useHome";
import "./airfields.css";

/** So many are listed. */
const LISTED = 5;
/** Looked for anew when the aircraft has gone this far, in degrees: about a kilometre. */
const PLACES = 2;

/** The airfields that are nearest to the followed aircraft, or to home while its position is not known. */
export function AirfieldsSection() {
  const { t } = useTranslation();
  const mapSelection = usePart(SELECTION);
  const chosen = useMapThing();
  const distance = useUnit("distance");
  const { place, name } = usePlace();
  const near = useNear(place);
  const states = {
    none: t("map.airfields.none"),
    failed: t("map.airfields.failed"),
    reading: t("map.airfields.reading"),
  };
  const names = {
    flight: t("map.airfields.fromFlight"),
    hil: t("map.airfields.fromHil"),
    home: t("map.airfields.fromHome"),
  };
  return (
    <Panel title={t("map.airfields.title")}>
      <p className="map-layers-hint">
        {typeof near === "string" ? states[near] : t("map.airfields.from", { place: names[name] })}
      </p>
      <ul className="map-airfield-buttons">
        {(typeof near === "string" ? [] : near).map(({ airfield }) => {
          const { code, latitude_deg, longitude_deg } = airfield;
          const isChosen = chosen?.kind === "airfield" && chosen.code === code;
          const away_m = distance_m(place, airfield);
          const away = t("map.airfields.away", {
            distance: `${distance.format(away_m)} ${distance.label}`,
            bearing: formatHeading(bearing_deg(place, airfield), 0) ?? t("words.dash"),
          });
          return (
            <li key={code}>
              <Button
                pressed={isChosen}
                icon={<TowerControl size={14} aria-hidden="true" />}
                onPress={() =>
                  selectThing(
                    mapSelection,
                    isChosen ? null : { kind: "airfield", code, latitude_deg, longitude_deg },
                  )
                }
              >
                {`${code} · ${away}`}
              </Button>
            </li>
          );
        })}
      </ul>
    </Panel>
  );
}

/** Rounded, so that the list is not asked for with each sample. */
function usePlace(): { readonly place: Position; readonly name: "flight" | "hil" | "home" } {
  const followed = useFlownAircraft();
  const home = useHome();
  const rounded = (degrees: number): number => Number(degrees.toFixed(PLACES));
  const at = useTelemetry((telemetry) => {
    const place = aircraftPlace(telemetry, followed);
    return place === null ? null : `${rounded(place.latitude_deg)} ${rounded(place.longitude_deg)}`;
  });
  const [latitude_deg = 0, longitude_deg = 0] = at?.split(" ").map(Number) ?? [
    home.latitude_deg,
    home.longitude_deg,
  ];
  return { place: { latitude_deg, longitude_deg }, name: at === null ? "home" : followed };
}

function useNear({
  latitude_deg,
  longitude_deg,
}: Position): readonly NearAirfield[] | "none" | "failed" | "reading" {
  const [near, setNear] = useState<readonly NearAirfield[] | "none" | "failed" | "reading">("reading");
  useEffect(() => {
    let isWanted = true;
    keptWorld()
      .ask<"near">({ kind: "near", place: { latitude_deg, longitude_deg }, most: LISTED })
      .then(
        (found) => isWanted && setNear(found.length === 0 ? "none" : found),
        () => isWanted && setNear("failed"),
      );
    return () => {
      isWanted = false;
    };
  }, [latitude_deg, longitude_deg]);
  return near;
}
