import { createStore, type StoreApi } from "zustand/vanilla";
import type { Sample } from "../../protocol/envelope";
import { useTelemetry } from "../../store/hooks";
import { partName } from "../../store/parts";

export const AUTOMATICS = ["autopilot", "autotrim"] as const;
export type Automatic = (typeof AUTOMATICS)[number];

/** Part of a heartbeat: the control source, and autopilot and autotrim of the HIL aircraft. */
export interface Automatics extends Readonly<Record<Automatic, boolean>> {
  readonly source: "joystick" | "rc";
}

/**
 * With RC as source the transmitter's switches decide, and what they leave off stays off when the joystick is the source
 * again. `leftOff` is what was on before RC and is off after it, until it is on again or somebody has seen it.
 */
export interface SourceReturn {
  readonly leftOff: readonly Automatic[];
  /** What was on when the joystick was last the source; null before that. */
  readonly wasOn: readonly Automatic[] | null;
  /** RC is the source, or was by the last heartbeat. */
  readonly isAway: boolean;
}

export const NOTHING_LEFT_OFF: SourceReturn = { leftOff: [], wasOn: null, isAway: false };

/** The state after one more heartbeat; the same object if nothing changed. */
export function followSource(state: SourceReturn, heard: Automatics): SourceReturn {
  if (heard.source === "rc") {
    // What was left off before counts as wanted: RC did not ask for it to be off.
    return state.isAway
      ? state
      : { leftOff: [], wasOn: state.wasOn && all([...state.wasOn, ...state.leftOff]), isAway: true };
  }
  const missed = state.isAway ? (state.wasOn ?? []) : state.leftOff;
  const leftOff = missed.filter((name) => !heard[name]);
  const wasOn = AUTOMATICS.filter((name) => heard[name]);
  const isSame = !state.isAway && same(leftOff, state.leftOff) && same(wasOn, state.wasOn);
  return isSame ? state : { leftOff, wasOn, isAway: false };
}

function all(names: readonly Automatic[]): readonly Automatic[] {
  return AUTOMATICS.filter((name) => names.includes(name));
}

function same(one: readonly Automatic[], other: readonly Automatic[] | null): boolean {
  return other !== null && one.length === other.length && one.every((name) => other.includes(name));
}

export type SourceReturnStore = StoreApi<SourceReturn>;

export const SOURCE_RETURN = partName<SourceReturnStore>("source return");

export function createSourceReturn(): SourceReturnStore {
  return createStore<SourceReturn>(() => NOTHING_LEFT_OFF);
}

/** The heartbeats among these samples. */
export function takeHeartbeats(store: SourceReturnStore, samples: readonly Sample[]): void {
  for (const { topic, values } of samples) {
    const isJoystick = values["source_joystick"];
    if (topic === "heartbeat" && typeof isJoystick === "boolean") {
      store.setState((state) =>
        followSource(state, {
          source: isJoystick ? "joystick" : "rc",
          autopilot: values["autopilot_hil"] === true,
          autotrim: values["autotrim_hil"] === true,
        }),
      );
    }
  }
}

export type Source = "joystick" | "rc";

/** The control source that the board reports; null without a live heartbeat. */
export function useSource(): Source | null {
  return useTelemetry((telemetry, now_ms) => {
    const isJoystick = telemetry.liveFlag("heartbeat", "source_joystick", now_ms);
    return isJoystick === null ? null : isJoystick ? "joystick" : "rc";
  });
}
