import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../lib/aircraft";
import { formatHeading } from "../lib/format";
import { usePage } from "../store/hooks";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { Readout, type ReadoutHandle, type ReadoutPress } from "../ui/Readout";
import { useUnit } from "./useUnit";
import { windNow } from "./wind";

/** Height above the ground, where the station knows the ground and the position is live. */
export function HeightFigure({ aircraft, press }: { aircraft: Aircraft; press?: ReadoutPress }) {
  const { t } = useTranslation();
  const { connection } = usePage();
  const altitude = useUnit("altitude");
  const readout = useRef<ReadoutHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const isLive = telemetry.state(aircraft === "flight" ? "gps" : "simulator", now_ms) === "live";
      const height_ft = connection.getState().status?.surroundings[aircraft].height_ft ?? null;
      const shown = isLive ? height_ft : null;
      readout.current?.paint(
        shown === null ? null : altitude.format(shown),
        shown === null ? "none" : "live",
      );
    },
    [connection, altitude, aircraft],
  );
  usePaint("text", paint);
  return (
    <Readout ref={readout} label={t("map.figures.height")} unit={altitude.label} chars={5} press={press} />
  );
}

/** The wind that the real aircraft's values imply now; without all of them there is none. */
export function WindFigure({ press }: { press?: ReadoutPress }) {
  const { t } = useTranslation();
  const speed = useUnit("speed");
  const readout = useRef<ReadoutHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const wind = windNow(telemetry, "flight", now_ms);
      const text =
        wind === null ? null : `${formatHeading(wind.from_deg, 0)}° ${speed.format(wind.speed_kt)}`;
      readout.current?.paint(text, wind === null ? "none" : "live");
    },
    [speed],
  );
  usePaint("text", paint);
  return <Readout ref={readout} label={t("map.figures.wind")} unit={speed.label} chars={8} press={press} />;
}
