import type { Aircraft } from "../../lib/aircraft";
import { AIRCRAFT_COLOURS } from "../../scene/colours";

interface Kind {
  readonly plain: string;
  readonly casing: string;
  readonly rank: number;
}

/**
 * A track has its aircraft's colour. The edges tell the two apart when values colour them; where they lie over each
 * other, the real one is seen.
 */
export const TRACK_KINDS: Readonly<Record<Aircraft, Kind>> = {
  flight: { plain: AIRCRAFT_COLOURS.flight, casing: "#12100a", rank: 1 },
  hil: { plain: AIRCRAFT_COLOURS.hil, casing: "#ffffff", rank: 0 },
};
