import type { Position } from "../../lib/geodesy";

/** An airfield that was pressed on the map. */
export type PickedAirfield = Position & { readonly code: string };
