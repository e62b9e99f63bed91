import type { Aircraft } from "../../lib/aircraft";
import { captureRadius_m } from "../../lib/plan";
import { wrap180 } from "../../lib/units";
import type { LawSignal, SignalText } from "../../readouts/signals";

/** The steepest bank that the autopilot asks for. */
const STEEPEST_DEG = 30;
/** Nearer to its waypoint, in capture radii, it may be flying the circle round it, of whose course nothing is sent. */
const NEAR = 2;

/** Autopilot, bearing, distance and speed asked for, and track. */
const OPERANDS: Readonly<Record<Aircraft, readonly string[]>> = {
  hil: [
    "heartbeat.autopilot_hil",
    "fms_hil_plan.bearing_deg",
    "fms_hil_plan.distance_m",
    "fms_hil_plan.speed_kt",
    "simulator.horizontal_path_deg",
  ],
  flight: [
    "heartbeat.autopilot",
    "fms_plan.bearing_deg",
    "fms_plan.distance_m",
    "fms_plan.speed_kt",
    "gps.heading_deg",
  ],
};

/**
 * The bank, degrees, right wing down, that the board's autopilot asks for by its law of the course: the board does not
 * send it. None while the autopilot is off. `k_heading`: degrees of bank for each of the course; null: unknown.
 */
export function rollDemand(aircraft: Aircraft, k_heading: () => number | null, text: SignalText): LawSignal {
  return {
    ...text,
    law: `roll asked ${aircraft}`,
    operands: OPERANDS[aircraft],
    compute: ([autopilot, bearing_deg = null, distance_m = null, speed_kt = null, track_deg = null]) => {
      const gain = k_heading();
      const isKnown = bearing_deg !== null && distance_m !== null && speed_kt !== null && track_deg !== null;
      if (autopilot !== 1 || gain === null || !isKnown || distance_m < NEAR * captureRadius_m(speed_kt)) {
        return null;
      }
      const wanted_deg = gain * wrap180(bearing_deg - track_deg);
      return Math.max(-STEEPEST_DEG, Math.min(STEEPEST_DEG, wanted_deg));
    },
  };
}
