/**
 * Round scales. Angles run clockwise in degrees from 12 o'clock. The picture's units have their zero in the middle of
 * the dial, x right and y down; the housing has radius 100.
 */

/** An even scale bent round a dial. `sweep_deg` may be negative for one that runs anticlockwise. */
export interface Scale {
  readonly minimum: number;
  readonly maximum: number;
  readonly start_deg: number;
  readonly sweep_deg: number;
}

/** Whether a value is on its scale. */
export type Reach = "below" | "within" | "above";

/** Whether a value can be drawn: NaN and the infinities are no data, as `null` is. */
export function isDrawable(value: number | null | undefined): value is number {
  return value !== null && value !== undefined && Number.isFinite(value);
}

export function clamp(value: number, minimum: number, maximum: number): number {
  return Math.min(maximum, Math.max(minimum, value));
}

/** Angle of a value; beyond an end the pointer rests on that end. */
export function scaleAngle_deg(scale: Scale, value: number): number {
  const within = clamp(value, scale.minimum, scale.maximum);
  const share = (within - scale.minimum) / (scale.maximum - scale.minimum);
  return scale.start_deg + share * scale.sweep_deg;
}

export function reach(minimum: number, maximum: number, value: number): Reach {
  if (value < minimum) return "below";
  return value > maximum ? "above" : "within";
}

/** Point at `radius` in the direction `angle_deg`. */
export function polar(radius: number, angle_deg: number): { x: number; y: number } {
  const angle_rad = (angle_deg * Math.PI) / 180;
  return { x: round(radius * Math.sin(angle_rad)), y: round(-radius * Math.cos(angle_rad)) };
}

/** One SVG path of radial strokes, so that a whole ring of ticks is a single element. */
export function tickPath(angles_deg: readonly number[], inner: number, outer: number): string {
  return angles_deg
    .map((angle_deg) => {
      const from = polar(outer, angle_deg);
      const to = polar(inner, angle_deg);
      return `M${from.x} ${from.y}L${to.x} ${to.y}`;
    })
    .join("");
}

/** `first`, `first + step`, … up to and with `last`; free of accumulated rounding. */
export function series(first: number, last: number, step: number): number[] {
  return Array.from(
    { length: Math.floor((last - first) / step + 1e-9) + 1 },
    (_, index) => first + index * step,
  );
}

/** `value` on two decimals: a hundredth of a unit is less than a pixel at any size, and short in the document. */
export function round(value: number): number {
  const rounded = Math.round(value * 100) / 100;
  // No minus before a zero.
  return rounded === 0 ? 0 : rounded;
}
