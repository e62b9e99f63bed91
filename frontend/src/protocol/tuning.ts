import type { Aircraft } from "../lib/aircraft";
import { degreesFromRadians, feetFromMetres } from "../lib/units";
import type { ParameterName } from "./messages.gen";
import type { NumberField, TopicName } from "./topics";

export type SignalName =
  | "altitude"
  | "altitudeAsked"
  | "vvi"
  | "pitch"
  | "q"
  | "elevator"
  | "bearingAsked"
  | "track"
  | "roll"
  | "p"
  | "aileron"
  | "r"
  | "slip"
  | "rudder"
  | "speed"
  | "speedAsked"
  | "throttle";

/** Where a signal is heard, and how it comes into the unit in which it is drawn. */
export type TuningSignal = {
  [T in TopicName]: { readonly topic: T; readonly field: NumberField<T> };
}[TopicName] & {
  readonly unit: "ft" | "ftPerMin" | "deg" | "degPerS" | "kt" | null;
  readonly scale?: (value: number) => number;
};

/** The least that a plot of this unit spans: what one would still call a change in flight. Controls move by fractions of 1. */
export const LEAST_SPAN: Readonly<Record<NonNullable<TuningSignal["unit"]> | "none", number>> = {
  ft: 50,
  ftPerMin: 500,
  deg: 10,
  degPerS: 10,
  kt: 10,
  none: 0.4,
};

/** Signals that go on at zero after 360 degrees. */
export const TURNING: ReadonlySet<SignalName> = new Set<SignalName>(["bearingAsked", "track"]);

/** `hil`: of the simulator and the HIL plan. `flight`: of the board's own sensors. */
const SIGNALS: Readonly<Record<SignalName, Readonly<Record<Aircraft, TuningSignal>>>> = {
  altitude: {
    hil: { topic: "simulator", field: "altitude_indicated_ft", unit: "ft" },
    flight: { topic: "analog", field: "altitude_m", unit: "ft", scale: feetFromMetres },
  },
  altitudeAsked: {
    hil: { topic: "fms_hil_plan", field: "altitude_ft", unit: "ft" },
    flight: { topic: "fms_plan", field: "altitude_ft", unit: "ft" },
  },
  vvi: {
    hil: { topic: "simulator", field: "vvi_ft_min", unit: "ftPerMin" },
    flight: { topic: "analog", field: "vvi_ft_min", unit: "ftPerMin" },
  },
  pitch: {
    hil: { topic: "simulator", field: "pitch_deg", unit: "deg" },
    flight: { topic: "ahrs", field: "pitch_deg", unit: "deg" },
  },
  q: {
    hil: { topic: "simulator", field: "q_rad_s", unit: "degPerS", scale: degreesFromRadians },
    flight: { topic: "inertial", field: "gy_rad_s", unit: "degPerS", scale: degreesFromRadians },
  },
  elevator: {
    hil: { topic: "hil_surfaces", field: "elevator", unit: null },
    flight: { topic: "fly_by_wire", field: "elevator", unit: null },
  },
  bearingAsked: {
    hil: { topic: "fms_hil_plan", field: "bearing_deg", unit: "deg" },
    flight: { topic: "fms_plan", field: "bearing_deg", unit: "deg" },
  },
  track: {
    hil: { topic: "simulator", field: "horizontal_path_deg", unit: "deg" },
    flight: { topic: "gps", field: "heading_deg", unit: "deg" },
  },
  roll: {
    hil: { topic: "simulator", field: "roll_deg", unit: "deg" },
    flight: { topic: "ahrs", field: "roll_deg", unit: "deg" },
  },
  p: {
    hil: { topic: "simulator", field: "p_rad_s", unit: "degPerS", scale: degreesFromRadians },
    flight: { topic: "inertial", field: "gx_rad_s", unit: "degPerS", scale: degreesFromRadians },
  },
  aileron: {
    hil: { topic: "hil_surfaces", field: "aileron", unit: null },
    flight: { topic: "fly_by_wire", field: "aileron", unit: null },
  },
  r: {
    hil: { topic: "simulator", field: "r_rad_s", unit: "degPerS", scale: degreesFromRadians },
    flight: { topic: "inertial", field: "gz_rad_s", unit: "degPerS", scale: degreesFromRadians },
  },
  slip: {
    hil: { topic: "simulator", field: "beta_deg", unit: "deg" },
    flight: { topic: "analog", field: "beta_deg", unit: "deg" },
  },
  rudder: {
    hil: { topic: "hil_surfaces", field: "rudder", unit: null },
    flight: { topic: "fly_by_wire", field: "rudder", unit: null },
  },
  speed: {
    hil: { topic: "simulator", field: "indicated_airspeed_kt", unit: "kt" },
    flight: { topic: "analog", field: "calibrated_airspeed_kt", unit: "kt" },
  },
  speedAsked: {
    hil: { topic: "fms_hil_plan", field: "speed_kt", unit: "kt" },
    flight: { topic: "fms_plan", field: "speed_kt", unit: "kt" },
  },
  throttle: {
    hil: { topic: "hil_surfaces", field: "throttle", unit: null },
    flight: { topic: "fly_by_wire", field: "throttle", unit: null },
  },
};

export const LOOPS = ["altitude", "pitch", "heading", "roll", "rudder", "speed"] as const;
export type LoopName = (typeof LOOPS)[number];

interface Loop {
  readonly parameters: readonly ParameterName[];
  readonly signals: readonly SignalName[];
}

/** The control loops: which parameters each has, outermost first, and the signals which they move. */
const LOOP: Readonly<Record<LoopName, Loop>> = {
  altitude: {
    parameters: ["k_altura", "k_int_altura", "k_VVI"],
    signals: ["altitudeAsked", "altitude", "vvi", "pitch"],
  },
  pitch: {
    parameters: ["k_pitch", "k_elev", "k_int_pitch", "k_div_Q_init", "k_div_Q_speed"],
    signals: ["pitch", "q", "elevator"],
  },
  heading: { parameters: ["k_heading"], signals: ["bearingAsked", "track", "roll"] },
  roll: {
    parameters: ["k_roll", "k_airln", "k_div_P_init", "k_div_P_speed"],
    signals: ["roll", "p", "aileron"],
  },
  rudder: { parameters: ["k_rudder", "k_div_R_init", "k_div_R_speed"], signals: ["r", "slip", "rudder"] },
  speed: { parameters: ["k_div_velocidad"], signals: ["speedAsked", "speed", "throttle"] },
};

export function loopParameters(loop: LoopName): readonly ParameterName[] {
  return LOOP[loop].parameters;
}

/** What a loop moves, in the order in which it is drawn; for the aircraft chosen. */
export function loopSignals(
  loop: LoopName,
  aircraft: Aircraft,
): ReadonlyArray<readonly [SignalName, TuningSignal]> {
  return LOOP[loop].signals.map((name) => [name, SIGNALS[name][aircraft]]);
}

/** The loop that a parameter belongs to. */
export function loopOf(parameter: ParameterName): LoopName {
  const found = LOOPS.find((loop) => LOOP[loop].parameters.includes(parameter));
  if (found === undefined) {
    throw new Error(`${parameter} belongs to no loop`);
  }
  return found;
}
