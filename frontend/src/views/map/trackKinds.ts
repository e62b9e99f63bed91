import type { TrackName } from "../../protocol/track";

interface Kind {
  readonly plain: string;
  readonly casing: string;
  readonly rank: number;
}

/**
 * On a map the ground is the same in every theme, so these colours are too. The edges tell the two apart when values
 * colour them; where they lie over each other, the real one is seen.
 */
export const TRACK_KINDS: Readonly<Record<TrackName, Kind>> = {
  real: { plain: "#ffd91a", casing: "#12100a", rank: 1 },
  hil: { plain: "#7ddcf0", casing: "#ffffff", rank: 0 },
};
