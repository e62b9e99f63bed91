import type { Position } from "./geodesy";

/** The two aircraft, each with its plan and its track: the real one, and that of the simulator. */
export const AIRCRAFT = ["flight", "hil"] as const;
export type Aircraft = (typeof AIRCRAFT)[number];

/** What can be selected on the map. */
export type MapThing =
  | { readonly kind: "waypoint"; readonly plan: Aircraft; readonly row: number }
  | { readonly kind: "aircraft"; readonly plan: Aircraft }
  | { readonly kind: "home" }
  | ({ readonly kind: "airfield"; readonly code: string } & Position);

/** An airfield that was pressed on the map. */
export type PickedAirfield = Position & { readonly code: string };
