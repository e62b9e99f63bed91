import type { TrackName } from "../../protocol/track";

/** On a map the ground is the same in every theme, so these colours are too. The edges tell the two apart when values colour them. */
export const TRACK_KINDS: Readonly<Record<TrackName, { readonly plain: string; readonly casing: string }>> = {
  real: { plain: "#ffd91a", casing: "#12100a" },
  hil: { plain: "#7ddcf0", casing: "#ffffff" },
};
