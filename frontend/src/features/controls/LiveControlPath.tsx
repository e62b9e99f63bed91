import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { ControlPath } from "../../instruments/path/ControlPath";
import { useStickKind } from "../../readouts/useStick";
import { useConnection, useTelemetry } from "../../store/hooks";
import { readAutopilot } from "./axes";
import { useSource } from "./sourceReturn";

/** The present path of the control signal, as reported by the board and the gateway. */
export function LiveControlPath() {
  const { t } = useTranslation();
  const source = useSource();
  const stick = useStickKind();
  const gamepad = stick === "gamepad" || stick === "lost" ? stick : null;
  // Without a live heartbeat the source is unknown, and so is the path.
  const chosenPath = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.hil.path ?? null) : null,
  );
  const path = source === null ? null : chosenPath;
  const autopilot = useTelemetry((telemetry, now_ms) =>
    telemetry.state("heartbeat", now_ms) === "live" ? readAutopilot(telemetry) : null,
  );
  const labels = useMemo(
    () => ({
      joystick: gamepad === null ? t("path.joystick") : t(`gamepad.badge.${gamepad}`),
      rc: t("path.rc"),
      manual: t("path.manual"),
      assisted: t("path.assistedShort"),
      computer: t("path.computer"),
      autopilot: t("path.autopilot"),
      surfaces: t("path.surfaces"),
      ignored: t("path.ignored"),
      unknown: t("words.unknown"),
    }),
    [t, gamepad],
  );
  const isAutomatic = path === "assisted" && autopilot === true;
  const description = isAutomatic
    ? t("path.sentenceAutomatic")
    : t("path.sentence", {
        source:
          source === "joystick" && gamepad !== null
            ? t(`gamepad.badge.${gamepad}`)
            : t(`source.${source ?? "unknown"}`),
        path: t(`path.${path ?? "unknown"}`),
      });
  return (
    <div className="left-path">
      <ControlPath
        label={t("path.label")}
        description={description}
        labels={labels}
        source={source}
        path={path}
        autopilot={autopilot}
      />
    </div>
  );
}
