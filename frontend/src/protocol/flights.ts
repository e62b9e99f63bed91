import {
  type Check,
  type Checked,
  isNumber,
  isObject,
  isText,
  list,
  nullable,
  optional,
  shape,
} from "../lib/check";
import { isParameterList, isWaypointModel } from "./guards.gen";

const isNumbers = list(isNumber);
const isStretch: Check<readonly [number, number]> = (value): value is readonly [number, number] =>
  isNumbers(value) && value.length === 2;

/** The ground of the time bar: altitudes at even steps over the flight, null where there is none; gaps in `at_s`. */
export const isOverview = shape({
  duration_s: isNumber,
  altitude_ft: list(nullable(isNumber)),
  gaps: list(isStretch),
});
export type Overview = Checked<typeof isOverview>;

/** Something that happened. `kind` may be one that this page does not know. */
export const isFlightEvent = shape({
  t_s: isNumber,
  at_s: isNumber,
  kind: isText,
  name: isText,
  data: isObject,
  until_s: optional(nullable(isNumber)),
});
export type FlightEvent = Checked<typeof isFlightEvent>;
export const isFlightEvents = shape({ events: list(isFlightEvent) });

const isKnownPlan = nullable(shape({ waypoints: list(isWaypointModel) }));

/** What was known of the board at a moment: its gains and its plans; null where it had not been read. */
export const isKnown = shape({
  parameters: nullable(isParameterList),
  missions: shape({ flight: isKnownPlan, hil: isKnownPlan }),
});
export type Known = Checked<typeof isKnown>;
