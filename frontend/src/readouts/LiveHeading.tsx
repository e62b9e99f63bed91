import { useCallback, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { type HeadingHandle, HeadingIndicator } from "../instruments/heading/HeadingIndicator";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";

/** A number for an instrument, null if not live. Defined at module level, so that painters are stable. */
export type ReadLive = (telemetry: TelemetryStore, now_ms: number) => number | null;

export const boardHeading_deg: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("ahrs", "yaw_deg", now_ms);

/** The plan that is flown: with a simulator in the loop, the HIL plan. */
export function flownPlan(telemetry: TelemetryStore, now_ms: number): "fms_plan" | "fms_hil_plan" {
  return telemetry.state("xplane_info", now_ms) === "live" ? "fms_hil_plan" : "fms_plan";
}

/** The bearing of the plan that is flown, for the heading bug. */
export const boardBearing_deg: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber(flownPlan(telemetry, now_ms), "bearing_deg", now_ms);

/** The heading indicator with the flight plan's bearing as its bug. */
export function LiveHeading({ heading_deg, bearing_deg }: { heading_deg: ReadLive; bearing_deg: ReadLive }) {
  const { t } = useTranslation();
  const instrument = useRef<HeadingHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) =>
      instrument.current?.paint(heading_deg(telemetry, now_ms), bearing_deg(telemetry, now_ms), now_ms),
    [heading_deg, bearing_deg],
  );
  usePaint("movement", paint);
  const describe = useCallback(
    (heading: number, bug: number | null) =>
      bug === null
        ? t("heading.sentence", { heading: heading.toFixed(0) })
        : t("heading.sentenceWithBearing", { heading: heading.toFixed(0), bearing: bug.toFixed(0) }),
    [t],
  );
  const cardinals = useMemo(
    () => ({
      north: t("heading.north"),
      east: t("heading.east"),
      south: t("heading.south"),
      west: t("heading.west"),
    }),
    [t],
  );
  return (
    <HeadingIndicator
      ref={instrument}
      label={t("heading.indicator")}
      noDataText={t("words.noData")}
      cardinals={cardinals}
      describe={describe}
    />
  );
}
