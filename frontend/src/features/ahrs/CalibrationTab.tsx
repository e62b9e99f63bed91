import { useState } from "react";
import { useTranslation } from "react-i18next";
import { DIRECTIONS, type Side } from "../../lib/sphereCover";
import { LiveBadge, StreamOff, useStreamIsOff } from "../../readouts/StreamPanel";
import { usePart, useTelemetry } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { AHRS } from "./alignment";
import { FitPanel } from "./FitPanel";
import { SpherePicture } from "./SpherePicture";
import { liveVectors } from "./source";
import { type Calibration, useCalibration } from "./useCalibration";

/** "Calibración del magnetómetro": readings while the board is turned, and the field fitted to them. */
export function CalibrationTab() {
  const [isOn, setOn] = useState(false);
  const { calibration, onReading } = useCalibration(isOn);
  return (
    <div className="ahrs3d-body">
      <SpherePicture calibration={calibration} onReading={onReading} />
      <div className="ahrs3d-side">
        <CollectPanel isOn={isOn} onSwitch={setOn} calibration={calibration} />
        <FitPanel calibration={calibration} />
      </div>
    </div>
  );
}

const HINTS = {
  nose: "ahrs3d.turn.nose",
  tail: "ahrs3d.turn.tail",
  right: "ahrs3d.turn.right",
  left: "ahrs3d.turn.left",
  belly: "ahrs3d.turn.belly",
  top: "ahrs3d.turn.top",
} as const satisfies Readonly<Record<Side, string>>;

interface CollectProps {
  isOn: boolean;
  onSwitch: (isOn: boolean) => void;
  calibration: Calibration;
}

function CollectPanel({ isOn, onSwitch, calibration }: CollectProps) {
  const { t } = useTranslation();
  const { samples } = usePart(AHRS);
  const isOff = useStreamIsOff("inertial");
  const hasField = useTelemetry((telemetry, now_ms) => liveVectors(telemetry, now_ms).field !== null);
  const { seen, missing, count } = calibration;
  const known = seen.filter((times) => times > 0).length;
  const [, setRevision] = useState(0);
  return (
    <Panel
      title={t("ahrs3d.collect")}
      badge={isOff ? undefined : <LiveBadge topic="inertial" />}
      actions={isOff ? <StreamOff topic="inertial" narrow={false} /> : undefined}
    >
      <div className="ahrs3d-row">
        <Button
          pressed={isOn}
          onPress={() => onSwitch(!isOn)}
          disabledReason={hasField || isOn ? undefined : t("ahrs3d.noField")}
        >
          {t(isOn ? "ahrs3d.pause" : "ahrs3d.begin")}
        </Button>
        <Button
          onPress={() => {
            if (samples.canRestore) {
              samples.restore();
            } else {
              samples.clear();
            }
            setRevision(samples.revision);
          }}
          disabledReason={count === 0 && !samples.canRestore ? t("ahrs3d.nothingCollected") : undefined}
        >
          {t(samples.canRestore ? "ahrs3d.restore" : "ahrs3d.clear")}
        </Button>
      </div>
      <div className="ahrs3d-cover">
        {isOn && !hasField && <Notice level="warning">{t("ahrs3d.noField")}</Notice>}
        <progress
          className="ahrs3d-progress"
          aria-label={t("ahrs3d.coverage")}
          max={DIRECTIONS.length}
          value={known}
        />
        <p>{t("ahrs3d.directions", { known, all: DIRECTIONS.length, readings: count })}</p>
        <p role="status">{missing === null ? t("ahrs3d.turn.done") : t(HINTS[missing])}</p>
      </div>
    </Panel>
  );
}
