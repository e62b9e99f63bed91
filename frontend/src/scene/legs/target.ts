import type { MapThing } from "../../lib/aircraft";
import type { Position } from "../../lib/geodesy";
import type { Spot } from "./geometry";
import type { LegPlace } from "./legHit";

/** A point on the ground; with terrain, its height above the sea, metres. */
export interface GroundPlace extends Position {
  readonly height_m: number | null;
}

/** What lies at a spot of the map. */
export interface MapTarget {
  /** Pixels from the map's upper left corner. */
  readonly at: Spot;
  /** The ground there; null in the sky. */
  readonly place: GroundPlace | null;
  readonly thing: MapThing | null;
  readonly leg: LegPlace | null;
}

/** Within so many pixels a thing is meant: of a mouse or pen, and of a finger. */
export const REACH_PX = { mouse: 14, touch: 26 } as const;
/** The same for a leg, which lies between things. */
export const LEG_REACH_PX = 12;

/** The reach of a pointer of this type. */
export function reachOf(pointerType: string): number {
  return pointerType === "touch" ? REACH_PX.touch : REACH_PX.mouse;
}
