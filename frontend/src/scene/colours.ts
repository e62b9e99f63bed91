import type { Aircraft } from "../lib/aircraft";

// The ground is the same in every theme, so these colours are too. They are strings, for the globe and for the 2D
// map, which must not load the globe's engine.

/** The outline of everything drawn over the ground: visible on any image. */
export const EDGE = "#0a0d0f";
/** What is active or selected. */
export const STRONG = "#ffffff";
export const AIRCRAFT_COLOURS: Readonly<Record<Aircraft, string>> = { flight: "#ffd91a", hil: "#7ddcf0" };
export const PLAN: Readonly<Record<Aircraft, string>> = { flight: "#f58be8", hil: "#7ddcf0" };
/** What the board does not have yet. */
export const UNSENT = "#ffb62e";
export const HOME = "#8df0b8";
/** The distance tool's line: no plan and no track is of this colour. */
export const MEASURE = "#b7f55a";
/** The area of a survey. */
export const AREA = "#ff9d7a";
/** The fence, and the track that leads into the ground or out of the fence. */
export const FENCE = "#c9a6ff";
export const WARNED = "#ff4d4d";

export const SEA = "#2a5c85";
export const LAND = "#837f5b";
export const COAST = "#f2e9c9";
/** Runways, and what is painted on them. */
export const ASPHALT = "#33383c";
export const PAINT = "#f4f4f0";
