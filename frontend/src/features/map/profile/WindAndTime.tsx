import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { formatFixed, formatHeading } from "../../../lib/format";
import { legsOf, type Waypoint } from "../../../lib/plan";
import { legTimes_s } from "../../../lib/wind";
import { useUnit } from "../../../readouts/useUnit";
import { usePage } from "../../../store/hooks";
import { choose } from "../../../store/settings";
import { Button } from "../../../ui/Button";
import { NumberField } from "../../../ui/NumberField";
import { useEnteredWind, useHasWind, WIND_CHOICES, windNow } from "./useWind";

/** Stronger wind than this is a mistake of the person or of the estimate. */
const STRONGEST_KT = 100;

/** The wind, entered or from the aircraft, and the time of each leg in it. */
export function WindAndTime({ aircraft, waypoints }: { aircraft: Aircraft; waypoints: readonly Waypoint[] }) {
  const { t } = useTranslation();
  const { settings, telemetry, pump } = usePage();
  const speed = useUnit("speed");
  const distance = useUnit("distance");
  const wind = useEnteredWind();
  const hasWind = useHasWind(aircraft);
  const legs = legsOf(waypoints);
  const times_s = legTimes_s(waypoints, wind);
  const isFlown = times_s.every((time_s) => time_s !== null);
  const total_s = times_s.reduce<number>((sum, time_s) => sum + (time_s ?? 0), 0);

  function take(): void {
    const found = windNow(telemetry, aircraft, pump.now_ms);
    if (found !== null) {
      choose(settings, WIND_CHOICES.from, found.from_deg.toFixed(0));
      choose(settings, WIND_CHOICES.speed, found.speed_kt.toFixed(1));
    }
  }

  return (
    <>
      <NumberField
        label={t("map.profile.windFrom")}
        value={wind.from_deg}
        minimum={0}
        maximum={360}
        step={10}
        format={(value) => value.toFixed(0)}
        unit={t("unit.deg")}
        onCommit={(value) => choose(settings, WIND_CHOICES.from, String(value))}
      />
      <NumberField
        label={t("map.profile.wind")}
        value={speed.convert(wind.speed_kt)}
        minimum={0}
        maximum={speed.convert(STRONGEST_KT)}
        step={1}
        format={(value) => value.toFixed(speed.digits)}
        unit={speed.label}
        onCommit={(shown) => choose(settings, WIND_CHOICES.speed, String(speed.revert(shown)))}
      />
      <Button onPress={take} disabledReason={hasWind ? undefined : t("map.profile.noWind")}>
        {t("map.profile.takeWind")}
      </Button>
      <p role="status">
        {isFlown ? t("map.profile.total", { time: clock(total_s) }) : t("map.profile.tooStrong")}
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
                time: times_s[index] == null ? t("words.dash") : clock(times_s[index]),
              })}
            </li>
          ))}
        </ol>
      </details>
    </>
  );
}

/** Minutes and seconds: "12:05". */
function clock(time_s: number): string {
  const whole = Math.round(time_s);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}
