import {
  type Checked,
  dictionary,
  isFlag,
  isNumber,
  isText,
  list,
  nullable,
  oneOf,
  shape,
} from "../lib/check";
import type { components } from "./api.gen";

const isValue = (value: unknown): value is string | number | boolean | null =>
  value === null || isNumber(value) || isText(value) || isFlag(value);

/** Everything that goes over the lines, as the gateway counted it. */
export const isInspection = shape({
  t_s: isNumber,
  board: list(
    shape({
      id: isNumber,
      name: isText,
      count: isNumber,
      rate_hz: isNumber,
      jitter_ms: nullable(isNumber),
      damaged: isNumber,
      age_s: nullable(isNumber),
      stale_after_s: nullable(isNumber),
      values: nullable(dictionary(isValue)),
    }),
  ),
  rows: list(
    shape({
      row: isNumber,
      name: isText,
      expected: isFlag,
      count: isNumber,
      rate_hz: isNumber,
      jitter_ms: nullable(isNumber),
      age_s: nullable(isNumber),
      values: nullable(list(nullable(isNumber))),
    }),
  ),
  link: shape({
    rx_bytes_per_s: isNumber,
    tx_bytes_per_s: isNumber,
    capacity_bytes_per_s: nullable(isNumber),
    rx_percent: nullable(isNumber),
    tx_percent: nullable(isNumber),
    simulator_bytes_per_s: isNumber,
    simulator_percent: isNumber,
    round_trip_ms: shape({ newest: nullable(isNumber), p50: nullable(isNumber), p99: nullable(isNumber) }),
    round_trips: isNumber,
  }),
  advice: list(
    shape({
      code: isText,
      level: oneOf("info", "warning"),
      text: isText,
      params: dictionary(isValue),
    }),
  ),
});

export type Inspection = Checked<typeof isInspection>;
export type InspectedFrame = Inspection["board"][number];
export type InspectedRow = Inspection["rows"][number];
export type Advice = Inspection["advice"][number];

/** Does not compile when the gateway describes its inspector otherwise than it is checked here. */
export const inspectorIsAsDescribed: components["schemas"]["Inspector"] extends Inspection ? true : false =
  true;
