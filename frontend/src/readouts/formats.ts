import { formatFixed, formatHeading } from "../lib/format";
import { degreesFromRadians } from "../lib/units";

/** How a number of a topic is written. Defined at module level, so that painters which use them are stable. */
export type Format = (value: number | null) => string | null;

export const whole: Format = (value) => formatFixed(value, 0);
export const tenths: Format = (value) => formatFixed(value, 1);
export const hundredths: Format = (value) => formatFixed(value, 2);
export const thousandths: Format = (value) => formatFixed(value, 3);
/** Six decimals of a degree are 0.1 m, finer than the board's single precision. */
export const coordinate: Format = (value) => formatFixed(value, 6);
export const heading: Format = (value) => formatHeading(value, 1);
export const degreesPerSecond: Format = (value) =>
  value === null ? null : formatFixed(degreesFromRadians(value), 1);
