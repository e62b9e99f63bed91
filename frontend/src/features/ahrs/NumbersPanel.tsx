import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import { wrap180 } from "../../lib/angles";
import { formatFixed, formatHeading } from "../../lib/format";
import { degreesPerSecond, heading, tenths } from "../../readouts/formats";
import { LiveReadout } from "../../readouts/LiveReadout";
import { usePage, usePart, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Button } from "../../ui/Button";
import { Panel } from "../../ui/Panel";
import { Readout, ReadoutGrid, type ReadoutHandle } from "../../ui/Readout";
import { AHRS, type AttitudeSource, align } from "./alignment";
import { useAlignment } from "./useAlignment";

interface Props {
  source: AttitudeSource;
  /** The present yaw became zero, or is none any more. */
  onAligned: () => void;
}

/** Angles and rates as numbers, and the alignment. */
export function NumbersPanel({ source, onAligned }: Props) {
  const { t } = useTranslation();
  const deg = t("unit.deg");
  const rate = t("unit.degPerS");
  return (
    <Panel title={t("ahrs3d.numbers")}>
      <ReadoutGrid>
        <LiveReadout
          key={`${source} yaw`}
          topic={source}
          field="yaw_deg"
          format={heading}
          label={t("attitude.heading")}
          unit={deg}
          chars={5}
        />
        <AlignedYaw source={source} />
        <LiveReadout
          key={`${source} pitch`}
          topic={source}
          field="pitch_deg"
          format={tenths}
          label={t("attitude.pitch")}
          unit={deg}
          chars={5}
        />
        <LiveReadout
          key={`${source} roll`}
          topic={source}
          field="roll_deg"
          format={tenths}
          label={t("attitude.roll")}
          unit={deg}
          chars={5}
        />
        <LiveReadout
          topic="inertial"
          field="gx_rad_s"
          format={degreesPerSecond}
          label={t("axis.p")}
          unit={rate}
          chars={5}
        />
        <LiveReadout
          topic="inertial"
          field="gy_rad_s"
          format={degreesPerSecond}
          label={t("axis.q")}
          unit={rate}
          chars={5}
        />
        <LiveReadout
          topic="inertial"
          field="gz_rad_s"
          format={degreesPerSecond}
          label={t("axis.r")}
          unit={rate}
          chars={5}
        />
      </ReadoutGrid>
      <AlignTools source={source} onAligned={onAligned} />
    </Panel>
  );
}

/** Yaw from the heading that was made zero: -180..180, to the right positive. */
function AlignedYaw({ source }: { source: AttitudeSource }) {
  const { t } = useTranslation();
  const zero_deg = useAlignment((alignment) => alignment[source]);
  const readout = useRef<ReadoutHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const yaw_deg = telemetry.newestNumber(source, "yaw_deg");
      const text =
        yaw_deg === null || zero_deg === null
          ? null
          : formatFixed(wrap180(Number((yaw_deg - zero_deg).toFixed(1))), 1);
      readout.current?.paint(text, telemetry.state(source, now_ms));
    },
    [source, zero_deg],
  );
  usePaint("text", paint);
  return <Readout ref={readout} label={t("ahrs3d.yaw")} unit={t("unit.deg")} chars={5} />;
}

function AlignTools({ source, onAligned }: Props) {
  const { t } = useTranslation();
  const { telemetry, pump } = usePage();
  const ahrs3d = usePart(AHRS);
  const zero_deg = useAlignment((alignment) => alignment[source]);
  const isLive = useTelemetry((each, now_ms) => each.liveNumber(source, "yaw_deg", now_ms) !== null);
  return (
    <div className="ahrs3d-row">
      <Button
        onPress={() => {
          align(ahrs3d.alignment, source, telemetry.liveNumber(source, "yaw_deg", pump.now_ms) ?? zero_deg);
          onAligned();
        }}
        disabledReason={isLive ? undefined : t("ahrs3d.nothingLive")}
      >
        {t("ahrs3d.align")}
      </Button>
      <Button
        onPress={() => {
          align(ahrs3d.alignment, source, null);
          onAligned();
        }}
        disabledReason={zero_deg === null ? t("ahrs3d.notAligned") : undefined}
      >
        {t("ahrs3d.unalign")}
      </Button>
      <p role="status" className="ahrs3d-aligned">
        {zero_deg === null ? "" : t("ahrs3d.aligned", { heading: formatHeading(zero_deg, 1) ?? "" })}
      </p>
    </div>
  );
}
