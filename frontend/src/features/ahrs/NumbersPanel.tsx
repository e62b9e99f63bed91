import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatFixed, formatHeading } from "../../lib/format";
import { wrap180 } from "../../lib/units";
import { Readouts } from "../../readouts/ReadoutTable";
import { PITCH_ROLL, TURN_RATES, YAW } from "../../readouts/rows";
import { usePage, usePart, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Button } from "../../ui/Button";
import { Panel } from "../../ui/Panel";
import { Readout, ReadoutGrid, type ReadoutHandle } from "../../ui/Readout";
import { AHRS, type AttitudeSource, align, useAlignment } from "./alignment";

interface Props {
  source: AttitudeSource;
  /** The user aligned the present yaw to zero, or removed the alignment. */
  onAligned: () => void;
}

/** Angles and rates as numbers, and the alignment. */
export function NumbersPanel({ source, onAligned }: Props) {
  const { t } = useTranslation();
  return (
    <Panel title={t("ahrs3d.numbers")}>
      <ReadoutGrid>
        <Readouts topic={source} rows={[YAW]} chars={5} />
        <AlignedYaw source={source} />
        <Readouts topic={source} rows={PITCH_ROLL} chars={5} />
        <Readouts {...TURN_RATES} chars={5} />
      </ReadoutGrid>
      <AlignTools source={source} onAligned={onAligned} />
    </Panel>
  );
}

/** Yaw relative to the aligned heading: -180..180, positive to the right. */
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
  const { telemetry } = usePage();
  const ahrs3d = usePart(AHRS);
  const zero_deg = useAlignment((alignment) => alignment[source]);
  // A late attitude is taken too: the button must not come and go under the hand that presses it.
  const isKnown = useTelemetry((each) => each.newestNumber(source, "yaw_deg") !== null);
  return (
    <div className="ahrs3d-row">
      <Button
        onPress={() => {
          align(ahrs3d.alignment, source, telemetry.newestNumber(source, "yaw_deg") ?? zero_deg);
          onAligned();
        }}
        disabledReason={isKnown ? undefined : t("ahrs3d.nothingLive")}
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
