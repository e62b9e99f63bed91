import { useCallback, useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { FaultsNow } from "../../features/faults/FaultsNow";
import { formatAge, formatBytes } from "../../lib/format";
import { PageContext, useConnection, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Meter, type MeterHandle } from "../../ui/Meter";
import { SteadyText, type SteadyTextHandle } from "../../ui/SteadyText";
import { LastMessage } from "./LastMessage";
import { usePresentPage } from "./presentPage";

/** Bottom row: last message, and what is said of the links. */
export function StatusBar() {
  return (
    <footer className="app-status">
      <LastMessage />
      <FaultsNow />
      <LinkFigures />
    </footer>
  );
}

/** Of a small window: the last message, and what goes wrong in the simulator. */
export function MessageRow() {
  return (
    <div className="app-last">
      <LastMessage />
      <FaultsNow />
    </div>
  );
}

/** Health of the links of the vehicle that is shown, recording of the present one. */
export function LinkFigures() {
  const { t } = useTranslation();
  return (
    <>
      <Damage />
      <Use label={t("status.rx")} read="rx" />
      <Use label={t("status.tx")} read="tx" />
      <Use label={t("status.xplane")} read="xplane" />
      <LinkState />
      <PageContext value={usePresentPage()}>
        <Recording />
      </PageContext>
    </>
  );
}

function Damage() {
  const { t } = useTranslation();
  const total = useConnection(({ status }) => status?.board.frames_damaged ?? null);
  const recent = useConnection(({ damagedLastSecond }) => damagedLastSecond);
  return (
    <span className="app-status-item" data-level={recent > 0 ? "warning" : "normal"}>
      <span className="app-status-label">{t("status.damaged")}</span>
      <span className="app-number">{total ?? t("words.dash")}</span>
      <span className="app-number app-status-recent">{t("status.perSecond", { count: recent })}</span>
    </span>
  );
}

/** Load of a channel in percent; shown only while its link is open and the gateway is heard. */
function Use({ label, read }: { label: string; read: "rx" | "tx" | "xplane" }) {
  const meter = useRef<MeterHandle>(null);
  const { t } = useTranslation();
  const percent = useConnection(({ status, phase }) => {
    if (status === null || phase !== "open") {
      return null;
    }
    const { board, simulator } = status;
    return { rx: board.rx_percent, tx: board.tx_percent, xplane: simulator.percent }[read];
  });
  useEffect(() => {
    meter.current?.paint(percent, percent === null ? t("words.dash") : `${percent.toFixed(0)} %`);
  }, [percent, t]);
  return <Meter ref={meter} label={label} />;
}

/**
 * State of the board's link and the age of its last heartbeat. The age is shown even when the link is stale: it stays
 * true.
 */
export function LinkState() {
  const { t } = useTranslation();
  const age = useRef<SteadyTextHandle>(null);
  const state = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.board.state ?? "closed") : "unknown",
  );
  const heartbeat = useTelemetry((telemetry, now_ms) => telemetry.state("heartbeat", now_ms));
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const age_s = telemetry.age_s("heartbeat", now_ms);
      age.current?.write(age_s === null ? t("words.dash") : formatAge(age_s));
    },
    [t],
  );
  usePaint("text", paint);
  const level = state === "open" && heartbeat === "live" ? "good" : state === "closed" ? "normal" : "warning";
  return (
    <span className="app-status-item" data-level={level}>
      <span className="app-lamp" aria-hidden="true" />
      <span>{t(state === "open" && heartbeat === "stale" ? "link.silent" : `link.${state}`)}</span>
      <span className="app-status-label">{t("status.heartbeat")}</span>
      <SteadyText ref={age} chars={6} className="app-number" />
    </span>
  );
}

function Recording() {
  const { t } = useTranslation();
  const recording = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.recording ?? null) : null,
  );
  const file = recording?.active ? recording.file : null;
  const failure = recording?.failure ?? null;
  return (
    <span
      className="app-status-item"
      data-level={failure !== null ? "warning" : file === null ? "normal" : "recording"}
    >
      <span className="app-lamp" aria-hidden="true" />
      <span className="app-status-label">{t("status.recording")}</span>
      {recording === null || file === null ? (
        <span>{failure === null ? t("status.notRecording") : t("status.recordingFailed")}</span>
      ) : (
        <>
          <span className="app-status-file" title={file}>
            {file.slice(file.lastIndexOf("/") + 1)}
          </span>
          <span className="app-number" title={t("status.recordingBytes")}>
            {formatBytes(recording.bytes)}
          </span>
        </>
      )}
    </span>
  );
}
