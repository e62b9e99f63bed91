import type { WaypointField } from "../lib/plan";
import type { CommandName } from "../protocol/messages.gen";
import type { PlanName } from "../protocol/missions";
import type { TelemetryStore } from "../store/telemetry";

interface PlanFacts {
  /** The topic in which the board reports the active waypoint. */
  readonly topic: "fms_plan" | "fms_hil_plan";
  /** Its number on the wire. */
  readonly number: 0 | 1;
  /** The heartbeat's flag of the autopilot that flies it. */
  readonly autopilot: "autopilot" | "autopilot_hil";
  readonly previous: CommandName;
  readonly next: CommandName;
  /** Base name of its files. */
  readonly file: string;
}

export const PLAN: Readonly<Record<PlanName, PlanFacts>> = {
  flight: {
    topic: "fms_plan",
    number: 0,
    autopilot: "autopilot",
    previous: "fms_previous_waypoint",
    next: "fms_next_waypoint",
    file: "epf-flight-plan",
  },
  hil: {
    topic: "fms_hil_plan",
    number: 1,
    autopilot: "autopilot_hil",
    previous: "hil_fms_previous_waypoint",
    next: "hil_fms_next_waypoint",
    file: "epf-hil-plan",
  },
};

/** Also by an old heartbeat: nobody has said since that the autopilot is off. */
export function isFlownByAutopilot(telemetry: TelemetryStore, plan: PlanName): boolean {
  return telemetry.newestFlag("heartbeat", PLAN[plan].autopilot) === true;
}

/** The editable columns, with their keys in the catalogue. */
export const COLUMN = {
  latitude_deg: "latitude",
  longitude_deg: "longitude",
  altitude_ft: "altitude",
  speed_kt: "speed",
} as const satisfies Readonly<Record<WaypointField, string>>;
