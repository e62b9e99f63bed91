import type { Aircraft } from "../../../lib/aircraft";
import { AIRCRAFT_COLOURS } from "../../../scene/colours";

interface Kind {
  readonly plain: string;
  readonly casing: string;
  readonly rank: number;
}

/**
 * A track has its aircraft's colour. When values colour the tracks, their edges tell them apart. Where they overlap,
 * the real one is on top.
 */
export const TRACK_KINDS: Readonly<Record<Aircraft, Kind>> = {
  flight: { plain: AIRCRAFT_COLOURS.flight, casing: "#12100a", rank: 1 },
  hil: { plain: AIRCRAFT_COLOURS.hil, casing: "#ffffff", rank: 0 },
};
