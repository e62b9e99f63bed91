import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import { type AttitudeHandle, AttitudeIndicator } from "../instruments/attitude/AttitudeIndicator";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";

/** The artificial horizon over a topic with pitch and roll. */
export function LiveAttitude({ topic }: { topic: "ahrs" | "ahrs_test" | "simulator" }) {
  const { t } = useTranslation();
  const instrument = useRef<AttitudeHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      instrument.current?.paint(
        {
          pitch_deg: telemetry.liveNumberOf(topic, "pitch_deg", now_ms),
          roll_deg: telemetry.liveNumberOf(topic, "roll_deg", now_ms),
        },
        now_ms,
      );
    },
    [topic],
  );
  usePaint("movement", paint);
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
