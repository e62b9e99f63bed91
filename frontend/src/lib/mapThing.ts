import type { Aircraft } from "./aircraft";

/** What can be selected on the map. */
export type MapThing =
  | { readonly kind: "waypoint"; readonly plan: Aircraft; readonly row: number }
  | { readonly kind: "aircraft"; readonly plan: Aircraft }
  | { readonly kind: "home" };
