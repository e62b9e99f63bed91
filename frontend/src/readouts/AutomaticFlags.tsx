import { useTranslation } from "react-i18next";
import { useTelemetry } from "../store/hooks";
import type { TelemetryStore } from "../store/telemetry";
import { LiveFlag } from "./LiveFlag";

/** The aircraft whose autopilot is meant: the one with the board in it, or the simulator's. */
type AutopilotSide = "flight" | "hil";

const AUTOPILOT = { flight: "autopilot", hil: "autopilot_hil" } as const;
const AUTOTRIM = { flight: "autotrim", hil: "autotrim_hil" } as const;

/** Autopilot and autotrim of one aircraft. The simulator's say so by their names. */
export function AutomaticFlags({ of }: { of: AutopilotSide }) {
  const { t } = useTranslation();
  return (
    <>
      <LiveFlag
        topic="heartbeat"
        read={(telemetry) => telemetry.newestFlag("heartbeat", AUTOPILOT[of])}
        label={t(of === "hil" ? "flag.autopilot_hil" : "flag.autopilot")}
      />
      <LiveFlag
        topic="heartbeat"
        read={(telemetry) => telemetry.newestFlag("heartbeat", AUTOTRIM[of])}
        label={t(of === "hil" ? "flag.autotrim_hil" : "flag.autotrim")}
      />
    </>
  );
}

/**
 * Under the real aircraft's flags: why they may differ from those beside the stick. Only while they do, by a live
 * heartbeat.
 */
export function OtherAutopilot() {
  const { t } = useTranslation();
  const other = useTelemetry(otherOf);
  return other === null ? null : <p className="live-note">{t(`automatic.${other}`)}</p>;
}

/** The HIL autopilot's state if the real one's is the opposite. */
function otherOf(telemetry: TelemetryStore, now_ms: number): "hilOn" | "hilOff" | null {
  const real = telemetry.liveFlag("heartbeat", "autopilot", now_ms);
  const hil = telemetry.liveFlag("heartbeat", "autopilot_hil", now_ms);
  if (real === null || hil === null || real === hil) {
    return null;
  }
  return hil ? "hilOn" : "hilOff";
}
