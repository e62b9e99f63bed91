import { type Checked, isNumber, isObject, isText, list, nullable, oneOf, shape } from "../lib/check";
import type { WaypointField } from "../lib/plan";
import type { PlanLimits } from "../lib/planCheck";
import type { components } from "./api.gen";
import { COMMANDS } from "./messages.gen";

export const PLANS = ["flight", "hil"] as const;
export type PlanName = (typeof PLANS)[number];

const isWaypoint = shape({
  latitude_deg: isNumber,
  longitude_deg: isNumber,
  altitude_ft: isNumber,
  speed_kt: isNumber,
});

/** A plan as the board has it. */
export const isMission = shape({ plan: oneOf(...PLANS), waypoints: list(isWaypoint) });

/** What becomes of a plan on its way to the board, whoever sends it. */
export const isMissionEvent = shape({
  plan: oneOf(...PLANS),
  state: oneOf("pending", "confirmed", "rejected"),
  client: nullable(isText),
});

/** The form in which other programs keep plans. */
export const PLAN_FORMATS = ["kml", "gpx", "csv", "plan"] as const;
export type PlanFormat = (typeof PLAN_FORMATS)[number];

/** A plan out of a file, with what had to be supposed on the way. */
export const isImportedPlan = shape({
  format: isText,
  waypoints: list(isWaypoint),
  notes: list(shape({ code: isText, params: isObject })),
});
export type ImportedPlan = Checked<typeof isImportedPlan>;

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

/** Does not compile when the gateway describes its plans otherwise than they are checked here. */
export const missionIsAsDescribed: components["schemas"]["Mission"] extends Checked<typeof isMission>
  ? true
  : false = true;
