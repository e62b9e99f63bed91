import { wrap360 } from "./units";

/**
 * A number as rounded text, with a decimal point in every language: the station's users know it so, and a coordinate
 * can be copied. A value that is no finite number has no text: the caller shows "no data".
 */
export function formatFixed(value: number | null | undefined, digits: number): string | null {
  if (value === null || value === undefined || !Number.isFinite(value)) {
    return null;
  }
  const text = value.toFixed(digits);
  // -0.04 to one digit must not read "-0.0".
  return Number(text) === 0 ? (0).toFixed(digits) : text;
}

/** A float of the wire has seven significant digits. */
export const WIRE_FIGURES = 7;

/** A measured number to so many significant digits; a large one keeps all digits before the point. */
export function formatMeasured(value: number | null | undefined, figures = 5): string | null {
  if (value === null || value === undefined || !Number.isFinite(value)) {
    return null;
  }
  const before = Math.max(1, Math.floor(Math.log10(Math.abs(value))) + 1);
  return formatFixed(value, Math.max(0, figures - before));
}

/** A heading, bearing or track: 0..360, never "360.0", because it is rounded before it is wrapped. */
export function formatHeading(angle_deg: number | null | undefined, digits: number): string | null {
  if (angle_deg === null || angle_deg === undefined || !Number.isFinite(angle_deg)) {
    return null;
  }
  const rounded = Number(wrap360(angle_deg).toFixed(digits));
  return wrap360(rounded).toFixed(digits);
}

/** Age of a value: tenths up to ten seconds, then seconds, then minutes and hours. */
export function formatAge(age_s: number): string {
  const age = Math.max(0, age_s);
  if (age < 9.95) {
    return `${age.toFixed(1)} s`;
  }
  if (age < 59.5) {
    return `${Math.round(age)} s`;
  }
  const minutes = Math.round(age / 60);
  return minutes < 60 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

const SIZES = ["B", "kB", "MB", "GB", "TB"] as const;

/** Minutes and seconds: "12:05". */
export function formatMinutes(time_s: number): string {
  const whole = Math.round(time_s);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** Bytes with decimal prefixes, three significant digits. */
export function formatBytes(bytes: number): string {
  let value = bytes;
  let step = 0;
  while (value >= 999.5 && step < SIZES.length - 1) {
    value /= 1000;
    step += 1;
  }
  const digits = step === 0 || value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
  return `${value.toFixed(digits)} ${SIZES[step]}`;
}
