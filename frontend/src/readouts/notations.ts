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

/** How a number is written whose unit nobody chooses. */
export interface Notation {
  readonly format: Format;
  /** The word after the number; without one it has no unit. */
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
