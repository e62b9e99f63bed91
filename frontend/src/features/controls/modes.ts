import type { Aircraft } from "../../lib/aircraft";

/**
 * How a mode stands: `active` acts on the aircraft; `armed` is on, and acts once the control path leads through the board;
 * `unknown` is not reported by a live value.
 */
export type ModeState = "active" | "armed" | "off" | "unknown";

/** The heartbeat's flags of each aircraft's autopilot and autotrim. */
export const AUTOMATIC_FLAGS = {
  flight: { autopilot: "autopilot", autotrim: "autotrim" },
  hil: { autopilot: "autopilot_hil", autotrim: "autotrim_hil" },
} as const satisfies Readonly<Record<Aircraft, object>>;

/**
 * The state of autopilot or autotrim. `path` is that of the simulated aircraft's control signal, null if not known; a real
 * aircraft has no other path than its board.
 */
export function automaticState(
  isOn: boolean | null,
  aircraft: Aircraft,
  path: "manual" | "assisted" | null,
): ModeState {
  if (isOn === null) {
    return "unknown";
  }
  if (!isOn) {
    return "off";
  }
  return aircraft === "hil" && path === "manual" ? "armed" : "active";
}
