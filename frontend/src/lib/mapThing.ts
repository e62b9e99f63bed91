import type { Aircraft } from "./aircraft";
import type { Position } from "./geodesy";

/** What can be selected on the map. */
export type MapThing =
  | { readonly kind: "waypoint"; readonly plan: Aircraft; readonly row: number }
  | { readonly kind: "aircraft"; readonly plan: Aircraft }
  | { readonly kind: "home" }
  | ({ readonly kind: "airfield"; readonly code: string } & Position);

/** An airfield that was pressed on the map. */
export type PickedAirfield = Position & { readonly code: string };
