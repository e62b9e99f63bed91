/** Whose: the real aircraft's, or that of the simulator. */
export type Whose = "flight" | "hil";

/** What can be pointed at on the map. */
export type MapThing =
  | { readonly kind: "waypoint"; readonly plan: Whose; readonly row: number }
  | { readonly kind: "aircraft"; readonly plan: Whose }
  | { readonly kind: "home" };
