import type { ParseKeys } from "i18next";
import {
  coordinate,
  degreesPerSecond,
  type Format,
  heading,
  hundredths,
  tenths,
  thousandths,
  whole,
} from "./formats";

/** The notation of a number whose unit cannot be chosen. */
export interface Notation {
  readonly format: Format;
  /** Key of the unit's symbol; none for a number without a unit. */
  readonly unit?: ParseKeys;
}

export const COORDINATE: Notation = { format: coordinate, unit: "unit.deg" };
export const HEADING: Notation = { format: heading, unit: "unit.deg" };
export const ANGLE: Notation = { format: tenths, unit: "unit.deg" };
export const FINE_ANGLE: Notation = { format: hundredths, unit: "unit.deg" };
/** From the wire's radians a second. */
export const TURN_RATE: Notation = { format: degreesPerSecond, unit: "unit.degPerS" };
export const ACCELERATION: Notation = { format: hundredths, unit: "unit.mPerS2" };
export const LOAD: Notation = { format: hundredths, unit: "unit.g" };
export const VOLTAGE: Notation = { format: hundredths, unit: "unit.v" };
export const HECTOPASCALS: Notation = { format: tenths, unit: "unit.hpa" };
export const PASCALS: Notation = { format: tenths, unit: "unit.pa" };
export const PERCENT: Notation = { format: whole, unit: "unit.percent" };
export const COUNT: Notation = { format: whole };
export const THOUSANDTHS: Notation = { format: thousandths };
