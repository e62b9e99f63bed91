import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { ControlPath } from "../instruments/path/ControlPath";
import { useConnection, useTelemetry } from "../store/hooks";
import { readAutopilot } from "./controls";
import { useSource } from "./useSource";

/** The way that the control signal takes now, as board and gateway report it. */
export function LiveControlPath() {
  const { t } = useTranslation();
  const source = useSource();
  // Where no heartbeat tells the source, no signal is known to take any way.
  const chosenPath = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.hil.path ?? null) : null,
  );
  const path = source === null ? null : chosenPath;
  const autopilot = useTelemetry((telemetry, now_ms) =>
    telemetry.state("heartbeat", now_ms) === "live" ? readAutopilot(telemetry) : null,
  );
  const labels = useMemo(
    () => ({
      joystick: t("path.joystick"),
      rc: t("path.rc"),
      manual: t("path.manual"),
      assisted: t("path.assistedShort"),
      computer: t("path.computer"),
      autopilot: t("path.autopilot"),
      surfaces: t("path.surfaces"),
      ignored: t("path.ignored"),
      unknown: t("words.unknown"),
    }),
    [t],
  );
  const isAutomatic = path === "assisted" && autopilot === true;
  const description = isAutomatic
    ? t("path.sentenceAutomatic")
    : t("path.sentence", {
        source: t(`source.${source ?? "unknown"}`),
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
