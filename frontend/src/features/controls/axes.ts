import type { NumberField } from "../../protocol/topics";
import type { StickKind } from "../../readouts/useStick";
import type { DataState, TelemetryStore } from "../../store/telemetry";

export const AXES = ["elevator", "aileron", "rudder", "throttle"] as const;
export type Axis = (typeof AXES)[number];

/** Channels of the RC receiver by what they move. */
const RC_CHANNELS: Readonly<Record<Axis, NumberField<"servos_in">>> = {
  aileron: "channel_0",
  elevator: "channel_1",
  throttle: "channel_2",
  rudder: "channel_3",
};

/** Whether the joystick was the last reported source, however old: the age is shown beside it. */
export function isJoystick(telemetry: TelemetryStore): boolean {
  return telemetry.newestFlag("heartbeat", "source_joystick") === true;
}

/**
 * State of the chosen source's controls: the stick comes in the simulator's information, the RC in its channels. A
 * gamepad that was chosen but sends nothing has no position. Without a live heartbeat the source is unknown, so
 * neither counts as live.
 */
export function axisState(telemetry: TelemetryStore, now_ms: number, stick: StickKind | null): DataState {
  if (stick === "lost" && isJoystick(telemetry)) {
    // Then the board is sent a centred stick, which is nobody's position.
    return "none";
  }
  const state = telemetry.state(isJoystick(telemetry) ? "xplane_info" : "servos_in", now_ms);
  return state === "live" && telemetry.state("heartbeat", now_ms) !== "live" ? "stale" : state;
}

/** Newest position of an axis of the chosen source, -1..+1, throttle 0..1. */
export function axisNumber(telemetry: TelemetryStore, axis: Axis): number | null {
  return isJoystick(telemetry)
    ? telemetry.newestNumber("xplane_info", axis)
    : telemetry.newestNumber("servos_in", RC_CHANNELS[axis]);
}

/** Autopilot of the chosen source: with the joystick the HIL's flag, with RC the one of the transmitter's switch. */
export function readAutopilot(telemetry: TelemetryStore): boolean | null {
  return telemetry.newestFlag("heartbeat", isJoystick(telemetry) ? "autopilot_hil" : "autopilot");
}

export function readAutotrim(telemetry: TelemetryStore): boolean | null {
  return telemetry.newestFlag("heartbeat", isJoystick(telemetry) ? "autotrim_hil" : "autotrim");
}
