import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { formatFixed, formatHeading, formatMinutes } from "../../../lib/format";
import { legsOf, type Waypoint } from "../../../lib/plan";
import { legTimes_s } from "../../../lib/wind";
import { RehearsalPanel } from "../../../missions/RehearsalPanel";
import { useEnteredWind } from "../../../missions/useWind";
import { useUnit } from "../../../readouts/useUnit";

interface Props {
  aircraft: Aircraft;
  waypoints: readonly Waypoint[];
  onGo: (row: number) => void;
}

/** The wind, what a flight in it finds, and the time of each leg. */
export function WindAndTime({ aircraft, waypoints, onGo }: Props) {
  const { t } = useTranslation();
  const distance = useUnit("distance");
  const wind = useEnteredWind();
  const legs = legsOf(waypoints);
  const times_s = legTimes_s(waypoints, wind);
  const isFlown = times_s.every((time_s) => time_s !== null);
  const total_s = times_s.reduce<number>((sum, time_s) => sum + (time_s ?? 0), 0);

  return (
    <>
      <RehearsalPanel plan={aircraft} onGo={onGo} />
      <p role="status">
        {isFlown ? t("map.profile.total", { time: formatMinutes(total_s) }) : t("map.profile.tooStrong")}
      </p>
      <details className="map-profile-legs">
        <summary>{t("map.profile.legs")}</summary>
        <ol>
          {legs.map((leg, index) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: a leg is its number
            <li key={index}>
              {t("map.profile.leg", {
                from: index + 1,
                to: index + 2,
                distance: `${distance.format(leg.distance_m)} ${distance.label}`,
                bearing: formatHeading(leg.bearing_deg, 0) ?? t("words.dash"),
                climb: formatFixed(leg.climb_deg, 1) ?? t("words.dash"),
                time: times_s[index] == null ? t("words.dash") : formatMinutes(times_s[index]),
              })}
            </li>
          ))}
        </ol>
      </details>
    </>
  );
}
