import { useTranslation } from "react-i18next";
import { formatFixed } from "../../../lib/format";
import { type Colouring, SCALES } from "../../../lib/track/trackColours";
import type { TrackChoices } from "./useTrackLook";

type ScaleColouring = Exclude<Colouring, "none">;

/** The legend of the tracks' colours. */
export function TrackLegend({ colouring, shown, unit }: TrackChoices) {
  const { t } = useTranslation();
  if (colouring === "none") {
    return null;
  }
  if (shown === null) {
    return <p>{t("map.track.noValues")}</p>;
  }
  const middle = (shown.least + shown.most) / 2;
  const text = (value: number): string => formatFixed(value, Number.isInteger(value) ? 0 : 1) ?? "";
  const of: Readonly<Record<ScaleColouring, string>> = {
    height: t("map.track.scaleHeight", { unit }),
    speed: t("map.track.scaleSpeed", { unit }),
    climb: t("map.track.scaleClimb", { unit }),
  };
  return (
    <figure className="map-track-scale">
      <figcaption>{of[colouring]}</figcaption>
      <div
        className="map-track-bar"
        style={{ background: `linear-gradient(to right, ${SCALES[colouring].join(", ")})` }}
      />
      <div className="map-track-ticks">
        <span>{text(shown.least)}</span>
        <span>{text(middle)}</span>
        <span>{text(shown.most)}</span>
      </div>
    </figure>
  );
}
