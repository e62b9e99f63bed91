import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { AIRCRAFT, type Aircraft } from "../../lib/aircraft";
import { formatAge } from "../../lib/format";
import { formatClock } from "../../lib/moment";
import { COLOURINGS, type Colouring } from "../../lib/track/trackColours";
import { usePage, usePart } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Checkbox } from "../../ui/Checkbox";
import { Notice } from "../../ui/Notice";
import { Select } from "../../ui/Select";
import { FoldingPanel } from "./panels/FoldingPanel";
import { useFlat } from "./scenes/useFlat";
import { TrackLegend } from "./track/TrackLegend";
import { TrackTools } from "./track/TrackTools";
import { TRACK_KINDS } from "./track/trackKinds";
import { TRACK_LOG, useTracks } from "./track/trackLog";
import { useTrackLayer } from "./track/useTrackLayer";
import { useTrackLook } from "./track/useTrackLook";
import "./track/track.css";

/** The tracks: how they are drawn, how many points they have, and their commands. */
export function TrackSection() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { settings } = usePage();
  const trackLog = usePart(TRACK_LOG);
  const look = useTrackLook();
  useTrackLayer(look);
  const flat = useFlat();
  useEffect(() => trackLog.watch(), [trackLog]);
  const failure = useTracks((tracks) => tracks.failure);
  const malformed = useTracks((tracks) => tracks.malformed);
  const names: Readonly<Record<Colouring, string>> = {
    none: t("map.track.colourNone"),
    height: t("map.track.colourHeight"),
    speed: t("map.track.colourSpeed"),
    climb: t("map.track.colourClimb"),
  };
  return (
    <FoldingPanel name="track" title={t("map.track.title")}>
      <div className="map-track-rows">
        {AIRCRAFT.map((name) => (
          <TrackRow key={name} name={name} isShown={look.isShown[name]} />
        ))}
      </div>
      <Select
        label={t("map.track.colour")}
        options={COLOURINGS.map((value) => ({ value, label: names[value] }))}
        value={look.colouring}
        onChange={(value) => choose(settings, "map.track.colour", value)}
        placeholder=""
      />
      <TrackLegend {...look} />
      <Checkbox
        label={t("map.track.curtain")}
        checked={look.hasCurtain}
        onChange={(isOn) => choose(settings, "map.track.curtain", isOn ? "on" : "off")}
        disabledReason={flat.isShown ? t("map.flat.globeOnly") : undefined}
      />
      {failure !== null && <Notice level="warning">{sentence(failure)}</Notice>}
      {malformed > 0 && <p>{t("map.track.malformed", { count: malformed })}</p>}
      <TrackTools />
    </FoldingPanel>
  );
}

/** One track: whether it is drawn, its points, and from when to when they were flown. */
function TrackRow({ name, isShown }: { name: Aircraft; isShown: boolean }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const { count, total, first_s, last_s } = useTracks((tracks) => tracks.summary[name]);
  const { plain, casing } = TRACK_KINDS[name];
  const span =
    first_s === null || last_s === null
      ? t("map.track.empty")
      : t("map.track.span", {
          count,
          from: formatClock(first_s),
          to: formatClock(last_s),
          duration: formatAge(last_s - first_s),
        });
  return (
    <div className="map-track-row">
      <Checkbox
        label={t(`map.track.${name}`)}
        checked={isShown}
        onChange={(isOn) => choose(settings, `map.track.${name}`, isOn ? "on" : "off")}
      />
      <span
        className="map-track-sample"
        aria-hidden="true"
        style={{ background: plain, borderColor: casing }}
      />
      <span className="map-track-row-text">
        {total > count && count > 0 ? t("map.track.coming", { count, total }) : span}
      </span>
    </div>
  );
}
