import type { WaypointField } from "../lib/plan";
import type { PlanLimits } from "../lib/planCheck";
import type { Mission } from "./guards.gen";
import { COMMANDS } from "./messages.gen";

export type PlanName = Mission["plan"];
export const PLANS = ["flight", "hil"] as const satisfies readonly PlanName[];

/** The form in which other programs keep plans. */
export const PLAN_FORMATS = ["kml", "kmz", "gpx", "csv", "plan"] as const;
export type PlanFormat = (typeof PLAN_FORMATS)[number];

/** What the board takes, out of the definition of its commands. */
export const PLAN_LIMITS: PlanLimits = {
  count: range("mission_begin", "count"),
  fields: {
    latitude_deg: range("mission_item", "latitude_deg"),
    longitude_deg: range("mission_item", "longitude_deg"),
    altitude_ft: range("mission_item", "altitude_ft"),
    speed_kt: range("mission_item", "speed_kt"),
  } satisfies Record<WaypointField, unknown>,
};

function range(command: "mission_begin" | "mission_item", name: string) {
  const argument = COMMANDS[command].arguments.find((one) => one.name === name);
  if (argument?.minimum == null || argument.maximum === null) {
    throw new Error(`the definition of ${command} has no range for ${name}`);
  }
  return { minimum: argument.minimum, maximum: argument.maximum };
}
