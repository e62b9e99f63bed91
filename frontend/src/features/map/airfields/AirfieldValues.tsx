import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import type { Position } from "../../../lib/geodesy";
import { METRES_PER_FOOT } from "../../../lib/units";
import { useUnit } from "../../../readouts/useUnit";
import type { AirfieldAt, RunwayOf } from "../../../scene/world/cell";
import { runwayLength_m } from "../../../scene/world/runways";
import { keptWorld } from "../../../scene/world/World";
import { Facts, FromAircraft } from "../panels/cardParts";
import "./airfields.css";

type AirfieldAnswer = AirfieldAt | "reading" | "failed";

/** What is known of an airfield: runways, elevation, frequencies. */
export function AirfieldValues({ code, latitude_deg, longitude_deg }: Position & { code: string }) {
  const { t } = useTranslation();
  const airfield = useAirfield(code, latitude_deg, longitude_deg);
  const place = { latitude_deg, longitude_deg };
  return (
    <>
      {typeof airfield === "string" ? (
        <p className="map-card-note">
          {airfield === "reading" ? t("map.airfields.reading") : t("map.airfields.failed")}
        </p>
      ) : (
        <Known {...airfield} />
      )}
      <Facts place={place} />
      <FromAircraft aircraft="flight" to={place} />
      <FromAircraft aircraft="hil" to={place} />
    </>
  );
}

function useAirfield(code: string, latitude_deg: number, longitude_deg: number): AirfieldAnswer {
  const [read, setRead] = useState<AirfieldAnswer>("reading");
  useEffect(() => {
    let isWanted = true;
    setRead("reading");
    keptWorld()
      .ask<"airfield">({ kind: "airfield", code, place: { latitude_deg, longitude_deg } })
      .then(
        ([found]) => isWanted && setRead(found?.airfield ?? "failed"),
        () => isWanted && setRead("failed"),
      );
    return () => {
      isWanted = false;
    };
  }, [code, latitude_deg, longitude_deg]);
  return read;
}

function Known({ name, elevation_ft, runways, frequencies }: AirfieldAt) {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  return (
    <>
      <p className="map-card-note">{name}</p>
      <dl className="map-card-facts">
        <div>
          <dt>{t("map.airfields.elevation")}</dt>
          <dd>
            {elevation_ft === null ? t("words.dash") : `${altitude.format(elevation_ft)} ${altitude.label}`}
          </dd>
        </div>
      </dl>
      <h4>{t("map.airfields.runways")}</h4>
      {runways === null || runways.length === 0 ? (
        <p className="map-card-note">{t("map.airfields.noRunways")}</p>
      ) : (
        <ul className="map-airfield-list">
          {runways.map((runway) => (
            <li key={runway.ends.join("/")}>
              <Runway runway={runway} />
            </li>
          ))}
        </ul>
      )}
      <h4>{t("map.airfields.frequencies")}</h4>
      {frequencies === null || frequencies.length === 0 ? (
        <p className="map-card-note">{t("map.airfields.noFrequencies")}</p>
      ) : (
        <dl className="map-card-facts">
          {frequencies.map(({ type, description, mhz }) => (
            <div key={`${type} ${description} ${mhz}`}>
              <dt title={description}>{type}</dt>
              <dd>{`${mhz.toFixed(3)} ${t("map.airfields.megahertz")}`}</dd>
            </div>
          ))}
        </dl>
      )}
      <p className="map-card-note">{t("map.airfields.notForNavigation")}</p>
    </>
  );
}

function Runway({ runway }: { runway: RunwayOf }) {
  const { t } = useTranslation();
  const length = useUnit("distance");
  const { ends, length_ft, surface, isLit } = runway;
  const length_m = length_ft === null ? runwayLength_m(runway) : length_ft * METRES_PER_FOOT;
  const surfaces: Readonly<Record<string, string>> = {
    asphalt: t("map.airfields.surface.asphalt"),
    concrete: t("map.airfields.surface.concrete"),
    grass: t("map.airfields.surface.grass"),
    gravel: t("map.airfields.surface.gravel"),
    earth: t("map.airfields.surface.earth"),
    water: t("map.airfields.surface.water"),
    snow: t("map.airfields.surface.snow"),
  };
  const parts = [
    ends.filter((end) => end !== "").join("/"),
    length_m > 0 ? `${length.format(length_m)} ${length.label}` : t("words.dash"),
    surfaces[surface] ?? "",
    isLit ? t("map.airfields.lit") : "",
  ];
  return parts.filter((part) => part !== "").join(" · ");
}
