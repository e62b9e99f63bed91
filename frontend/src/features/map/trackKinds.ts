import type { TrackName } from "../../protocol/track";
import { AIRCRAFT } from "../../scene/colours";

interface Kind {
  readonly plain: string;
  readonly casing: string;
  readonly rank: number;
}

/**
 * A track has its aircraft's colour. The edges tell the two apart when values colour them; where they lie over each
 * other, the real one is seen.
 */
export const TRACK_KINDS: Readonly<Record<TrackName, Kind>> = {
  real: { plain: AIRCRAFT.flight, casing: "#12100a", rank: 1 },
  hil: { plain: AIRCRAFT.hil, casing: "#ffffff", rank: 0 },
};
