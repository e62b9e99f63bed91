import { useCallback, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { type AttitudeHandle, AttitudeIndicator } from "../instruments/attitude/AttitudeIndicator";
import { type HeadingHandle, HeadingIndicator } from "../instruments/heading/HeadingIndicator";
import { heading, tenths } from "../live/formats";
import { LiveReadout } from "../live/LiveReadout";
import { StreamPanel } from "../live/StreamPanel";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { ReadoutGrid } from "../ui/Readout";
import { ControlsPanel } from "./ControlsPanel";
import { LiveControlPath } from "./LiveControlPath";
import "./left-panel.css";

/** Attitude over heading, their numbers, and the controls of the chosen source: always in sight. */
export function LeftPanel() {
  const { t } = useTranslation();
  const deg = t("unit.deg");
  return (
    <aside className="left" aria-label={t("left.label")}>
      <div className="left-dials">
        <Attitude />
        <Heading />
      </div>
      <div className="left-numbers">
        <StreamPanel topic="ahrs" title={t("left.ahrs")} className="left-ahrs" narrow plain>
          <ReadoutGrid>
            <LiveReadout
              topic="ahrs"
              field="yaw_deg"
              format={heading}
              label={t("attitude.heading")}
              unit={deg}
              size="large"
              chars={5}
            />
            <LiveReadout
              topic="ahrs"
              field="pitch_deg"
              format={tenths}
              label={t("attitude.pitch")}
              unit={deg}
              size="large"
              chars={5}
            />
            <LiveReadout
              topic="ahrs"
              field="roll_deg"
              format={tenths}
              label={t("attitude.roll")}
              unit={deg}
              size="large"
              chars={5}
            />
          </ReadoutGrid>
        </StreamPanel>
        <ControlsPanel />
      </div>
      <LiveControlPath />
    </aside>
  );
}

function Attitude() {
  const { t } = useTranslation();
  const instrument = useRef<AttitudeHandle>(null);
  const paint = useCallback((telemetry: TelemetryStore, now_ms: number) => {
    instrument.current?.paint(
      {
        pitch_deg: telemetry.liveNumber("ahrs", "pitch_deg", now_ms),
        roll_deg: telemetry.liveNumber("ahrs", "roll_deg", now_ms),
      },
      now_ms,
    );
  }, []);
  usePaint("frame", paint);
  const describe = useCallback(
    (pitch_deg: number, roll_deg: number) =>
      t("attitude.sentence", { pitch: pitch_deg.toFixed(0), roll: roll_deg.toFixed(0) }),
    [t],
  );
  return (
    <AttitudeIndicator
      ref={instrument}
      label={t("attitude.indicator")}
      noDataText={t("words.noData")}
      describe={describe}
    />
  );
}

/**
 * The bearing which the bug shows: of the plan that is being flown, which with a simulator in the loop is the HIL one.
 */
function bearing_deg(telemetry: TelemetryStore, now_ms: number): number | null {
  const isHil = telemetry.state("xplane_info", now_ms) === "live";
  return telemetry.liveNumber(isHil ? "fms_hil_plan" : "fms_plan", "bearing_deg", now_ms);
}

function Heading() {
  const { t } = useTranslation();
  const instrument = useRef<HeadingHandle>(null);
  const paint = useCallback((telemetry: TelemetryStore, now_ms: number) => {
    const heading_deg = telemetry.liveNumber("ahrs", "yaw_deg", now_ms);
    instrument.current?.paint(heading_deg, bearing_deg(telemetry, now_ms), now_ms);
  }, []);
  usePaint("frame", paint);
  const describe = useCallback(
    (heading_deg: number, bug_deg: number | null) =>
      bug_deg === null
        ? t("heading.sentence", { heading: heading_deg.toFixed(0) })
        : t("heading.sentenceWithBearing", { heading: heading_deg.toFixed(0), bearing: bug_deg.toFixed(0) }),
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
