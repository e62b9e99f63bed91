import { isObject, isText } from "../../lib/check";
import { parseSignal } from "./signalNames";

/** The signals of each plot, from the top down. */
export type Panes = ReadonlyArray<readonly string[]>;

export interface Layout {
  readonly name: string;
  readonly panes: Panes;
}

/** As many as can be told apart by colour. */
export const MOST_SIGNALS = 6;
export const MOST_PANES = 8;

export const DEFAULTS = ["roll", "pitch", "speedAltitude", "heading", "battery", "link"] as const;
export type DefaultName = (typeof DEFAULTS)[number];

/** Layouts that every station has: the signals of both aircraft, of which a flight shows those that it has. */
export const DEFAULT_PANES: Readonly<Record<DefaultName, Panes>> = {
  roll: [
    ["ahrs.roll_deg", "simulator.roll_deg"],
    ["inertial.gx_rad_s", "simulator.p_rad_s"],
    ["hil_surfaces.aileron", "fly_by_wire.aileron"],
  ],
  pitch: [
    ["ahrs.pitch_deg", "simulator.pitch_deg"],
    ["inertial.gy_rad_s", "simulator.q_rad_s"],
    ["hil_surfaces.elevator", "fly_by_wire.elevator"],
  ],
  speedAltitude: [
    ["simulator.indicated_airspeed_kt", "analog.calibrated_airspeed_kt", "fms_hil_plan.speed_kt"],
    ["simulator.altitude_indicated_ft", "analog.altitude_m", "fms_hil_plan.altitude_ft"],
    ["error(simulator.altitude_indicated_ft,fms_hil_plan.altitude_ft)"],
  ],
  heading: [
    ["simulator.horizontal_path_deg", "gps.heading_deg", "fms_hil_plan.bearing_deg"],
    ["error(simulator.horizontal_path_deg,fms_hil_plan.bearing_deg)"],
  ],
  battery: [["analog.battery_v"], ["hil_surfaces.throttle", "fly_by_wire.throttle"]],
  link: [
    ["rate(board_status.frames_received)", "rate(board_status.frames_rejected)"],
    ["statistics.sensor_dsc_percent", "statistics.control_dsc_percent"],
    ["gps.satellites"],
  ],
};

export const FIRST: Panes = DEFAULT_PANES.roll;

/** The stored panes; null if the text is none. Unknown signals are left out. */
export function readPanes(text: string | undefined): Panes | null {
  return panesOf(parsed(text));
}

/** The layouts that this person stored. */
export function readLayouts(text: string | undefined): readonly Layout[] {
  const stored = parsed(text);
  return (Array.isArray(stored) ? stored : []).flatMap((one: unknown) => {
    const panes = isObject(one) ? panesOf(one["panes"]) : null;
    return isObject(one) && isText(one["name"]) && panes !== null ? [{ name: one["name"], panes }] : [];
  });
}

function panesOf(value: unknown): Panes | null {
  if (!Array.isArray(value) || value.length === 0) {
    return null;
  }
  return value
    .slice(0, MOST_PANES)
    .map((pane: unknown) =>
      (Array.isArray(pane) ? pane : [])
        .filter((name): name is string => isText(name) && parseSignal(name) !== null)
        .slice(0, MOST_SIGNALS),
    );
}

function parsed(text: string | undefined): unknown {
  try {
    return JSON.parse(text ?? "null");
  } catch {
    return null;
  }
}

/** The panes with this signal in one of them; the same panes if it is there, or there is no room. */
export function withSignal(panes: Panes, pane: number, name: string): Panes {
  const signals = panes[pane] ?? [];
  return signals.includes(name) || signals.length >= MOST_SIGNALS
    ? panes
    : panes.map((old, index) => (index === pane ? [...old, name] : old));
}

/** The panes with a plot of this signal, and which one it is: one that has it, or a new one above all others. */
export function withPlotOf(panes: Panes, name: string): { readonly panes: Panes; readonly pane: number } {
  const pane = panes.findIndex((signals) => signals.includes(name));
  return pane >= 0 ? { panes, pane } : { panes: [[name], ...panes].slice(0, MOST_PANES), pane: 0 };
}

export function withoutSignal(panes: Panes, pane: number, name: string): Panes {
  return panes.map((old, index) => (index === pane ? old.filter((one) => one !== name) : old));
}

/** The panes with two neighbours exchanged. */
export function movedPane(panes: Panes, pane: number, by: 1 | -1): Panes {
  const [one, other] = [panes[pane], panes[pane + by]];
  if (one === undefined || other === undefined) {
    return panes;
  }
  return panes.map((old, index) => (index === pane ? other : index === pane + by ? one : old));
}

/** The panes without one; the last one is only emptied. */
export function withoutPane(panes: Panes, pane: number): Panes {
  return panes.length === 1 ? [[]] : panes.filter((_, index) => index !== pane);
}

/** Every signal once, in the order of the panes. */
export function signalsOf(panes: Panes): readonly string[] {
  return [...new Set(panes.flat())];
}
