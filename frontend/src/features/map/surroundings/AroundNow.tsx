import { useTranslation } from "react-i18next";
import { useFlownAircraft } from "../../../readouts/flownAircraft";
import { useHeightText } from "../../../readouts/heightSets";
import { useUnit } from "../../../readouts/useUnit";
import { useConnection } from "../../../store/hooks";

/** What the station sees around the aircraft that is followed, or why it sees nothing. */
export function AroundNow() {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const heightText = useHeightText();
  const aircraft = useFlownAircraft();
  const around = useConnection(({ phase, status }) =>
    phase === "open" && status !== null ? status.surroundings[aircraft] : null,
  );
  const name = aircraft === "flight" ? t("map.view.flight") : t("map.view.hil");
  if (around === null || around.height_ft === null) {
    return (
      <p className="map-around-now" data-level="blind" role="status">
        {t(`mapBlind.${around?.blind ?? "no_position"}`, { name })}
      </p>
    );
  }
  const written = (altitude_ft: number): string => `${altitude.format(altitude_ft)} ${altitude.label}`;
  const threats = [around.terrain, around.fence].filter((threat) => threat !== null);
  return (
    <div className="map-around-now" role="status">
      <p>{t("map.around.height", { name, height: written(around.height_ft) })}</p>
      {around.heights.map((set) => (
        <p key={set.name} data-level={set.datum === null ? "blind" : undefined}>
          {heightText(set)}
        </p>
      ))}
      {threats.map(({ what, in_s }) => (
        <p key={what} data-level="warned">
          {t(`mapAhead.${what}`, { seconds: Math.round(in_s) })}
        </p>
      ))}
    </div>
  );
}
