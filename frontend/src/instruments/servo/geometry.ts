import { clamp } from "../dial/scale";

/** A surface swings both ways from the middle, -1 to +1; a throttle fills from one end, 0 to 1. */
export type ServoKind = "surface" | "throttle";

/** Up (or right) is positive. */
export type Orientation = "vertical" | "horizontal";

/** The bar's position as a share of the track from the negative end, and whether it was limited. */
export interface ServoBarState {
  /** 0 at the negative end, 1 at the positive end. */
  readonly place: number;
  /** The value is beyond the track's end. */
  readonly limited: boolean;
}

export function servoMinimum(kind: ServoKind): number {
  return kind === "surface" ? -1 : 0;
}

export function servoBar(kind: ServoKind, value: number): ServoBarState {
  const minimum = servoMinimum(kind);
  return {
    place: (clamp(value, minimum, 1) - minimum) / (1 - minimum),
    limited: value < minimum || value > 1,
  };
}

/** Share of the track at which the bar begins: the middle for a surface, the end for a throttle. */
export function servoOrigin(kind: ServoKind): number {
  return kind === "surface" ? 0.5 : 0;
}

/**
 * CSS transform of the fill, an element that covers the whole track with its transform origin at the negative
 * end. Moving and scaling it needs no new layout.
 */
export function fillTransform(kind: ServoKind, orientation: Orientation, place: number): string {
  const origin = servoOrigin(kind);
  const from = percent(Math.min(origin, place));
  const length = Math.abs(place - origin).toFixed(4);
  return orientation === "vertical"
    ? `translateY(${negative(from)}) scaleY(${length})`
    : `translateX(${from}) scaleX(${length})`;
}

/** CSS transform of the marker, an element as long as the track whose negative end carries the mark. */
export function markerTransform(orientation: Orientation, place: number): string {
  const along = percent(place);
  return orientation === "vertical" ? `translateY(${negative(along)})` : `translateX(${along})`;
}

function percent(share: number): string {
  return `${(share * 100).toFixed(2)}%`;
}

function negative(length: string): string {
  return Number.parseFloat(length) === 0 ? length : `-${length}`;
}
