import { useCallback, useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatAge } from "../../lib/format";
import { formatDateTime } from "../../lib/moment";
import { LiveAttitude } from "../../readouts/LiveAttitude";
import { LiveReadout } from "../../readouts/LiveReadout";
import { useConnection, usePart, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Button } from "../../ui/Button";
import { SteadyText, type SteadyTextHandle } from "../../ui/SteadyText";
import { PLAYBACK } from "./playbackRequests";
import { moment_s } from "./playbackState";
import { usePlayback } from "./usePlayback";

const READOUTS = [
  { topic: "analog", field: "altitude_m", label: "time.altitude", as: "altitude" },
  { topic: "analog", field: "calibrated_airspeed_kt", label: "time.airspeed", as: "speed" },
  { topic: "gps", field: "speed_kt", label: "time.groundSpeed", as: "speed" },
] as const;

/** Above everything while the past is shown: that it is the past and which, and beside it the present in small. */
export function PresentStrip() {
  const { t } = useTranslation();
  return (
    <div className="past-head">
      <PastWords />
      <section className="present" aria-label={t("time.present")}>
        <strong className="present-name">{t("time.presentName")}</strong>
        <div className="present-horizon">
          <LiveAttitude topic="ahrs" />
        </div>
        <Heartbeat />
        {READOUTS.map((readout) => (
          <LiveReadout key={readout.label} {...readout} />
        ))}
        <Stick />
        <Now />
      </section>
    </div>
  );
}

function PastWords() {
  const { t } = useTranslation();
  const { store } = usePart(PLAYBACK);
  const clock = useRef<SteadyTextHandle>(null);
  const isLost = usePlayback(({ state, isLost }) => isLost || state === "opening");
  useEffect(() => {
    const write = (): void => {
      const at_s = moment_s(store.getState());
      clock.current?.write(at_s === null ? t("words.dash") : formatDateTime(at_s));
    };
    write();
    return store.subscribe(write);
  }, [store, t]);
  return (
    <p className="past-words">
      <strong role="status">{t("time.past")}</strong>
      <SteadyText ref={clock} chars={19} className="past-clock" />
      {isLost && <span>{t("time.opening")}</span>}
    </p>
  );
}

/** The age of the present's heartbeat: true also when it is old. */
function Heartbeat() {
  const { t } = useTranslation();
  const age = useRef<SteadyTextHandle>(null);
  const state = useTelemetry((telemetry, now_ms) => telemetry.state("heartbeat", now_ms));
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const age_s = telemetry.age_s("heartbeat", now_ms);
      age.current?.write(age_s === null ? t("words.dash") : formatAge(age_s));
    },
    [t],
  );
  usePaint("text", paint);
  return (
    <span className="present-heartbeat" data-state={state}>
      <span className="present-label">{t("time.heartbeat")}</span>
      <SteadyText ref={age} chars={6} />
    </span>
  );
}

/** The stick in the hand is of the present: if it flew before, it goes on flying. */
function Stick() {
  const { t } = useTranslation();
  const flies = useConnection(
    ({ status, client }) => client !== null && status?.hil.stick?.client === client,
  );
  return (
    <span className="present-stick" role="status">
      {flies && t("time.stick")}
    </span>
  );
}

function Now() {
  const { t } = useTranslation();
  const playback = usePart(PLAYBACK);
  return (
    <Button variant="primary" onPress={playback.now} label={t("time.nowLong")}>
      {t("time.nowButton")}
    </Button>
  );
}
