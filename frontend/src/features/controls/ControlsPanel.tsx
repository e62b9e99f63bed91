import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import { ControlCross, type ControlCrossHandle } from "../../instruments/controls/ControlCross";
import { AutomaticFlags } from "../../readouts/AutomaticFlags";
import { hundredths } from "../../readouts/formats";
import { stickKind, useStickKind } from "../../readouts/useStick";
import { usePage, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Panel } from "../../ui/Panel";
import { Readout, ReadoutGrid, type ReadoutHandle } from "../../ui/Readout";
import { AXES, type Axis, axisNumber, axisState, isJoystick } from "./axes";
import { useSource } from "./sourceReturn";

/** "Controles": stick and throttle of the chosen source, and its autopilot and autotrim. */
export function ControlsPanel() {
  const { t } = useTranslation();
  const source = useSource() ?? "unknown";
  const stick = useStickKind();
  // The last reported source, however old: the flags show their age themselves.
  const flown = useTelemetry((telemetry) => isJoystick(telemetry));
  return (
    <Panel
      title={t("controls.title")}
      className="left-controls"
      badge={
        <span className="left-source" data-lost={source === "joystick" && stick === "lost"}>
          {source === "joystick" && (stick === "gamepad" || stick === "lost")
            ? t(`gamepad.badge.${stick}`)
            : t(`source.${source}`)}
        </span>
      }
    >
      <Cross />
      <ReadoutGrid>
        {AXES.map((axis) => (
          <AxisReadout key={axis} axis={axis} label={t(`control.${axis}`)} />
        ))}
      </ReadoutGrid>
      <div className="left-flags">
        <AutomaticFlags of={flown ? "hil" : "flight"} />
      </div>
    </Panel>
  );
}

function Cross() {
  const { t } = useTranslation();
  const { connection } = usePage();
  const cross = useRef<ControlCrossHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const state = axisState(telemetry, now_ms, stickKind(connection.getState()));
      const live = (axis: Axis): number | null => (state === "live" ? axisNumber(telemetry, axis) : null);
      cross.current?.paint(
        {
          aileron: live("aileron"),
          elevator: live("elevator"),
          rudder: live("rudder"),
          throttle: live("throttle"),
        },
        now_ms,
      );
    },
    [connection],
  );
  usePaint("movement", paint);
  return (
    <div className="left-cross">
      <ControlCross ref={cross} label={t("controls.picture")} noDataText={t("words.noData")} />
    </div>
  );
}

function AxisReadout({ axis, label }: { axis: Axis; label: string }) {
  const { connection } = usePage();
  const readout = useRef<ReadoutHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) =>
      readout.current?.paint(
        hundredths(axisNumber(telemetry, axis)),
        axisState(telemetry, now_ms, stickKind(connection.getState())),
      ),
    [axis, connection],
  );
  usePaint("text", paint);
  return <Readout ref={readout} label={label} chars={5} />;
}
