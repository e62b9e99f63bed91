import { useTelemetry } from "../../store/hooks";

export type Source = "joystick" | "rc";

/** The control source that the board reports; null without a live heartbeat. */
export function useSource(): Source | null {
  return useTelemetry((telemetry, now_ms) => {
    const isJoystick = telemetry.liveFlag("heartbeat", "source_joystick", now_ms);
    return isJoystick === null ? null : isJoystick ? "joystick" : "rc";
  });
}
