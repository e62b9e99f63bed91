import { Color, Material } from "@cesium/engine";

import type { Whose } from "../../lib/mapThing";

export type PlanKind = Whose;

/** On the globe the ground is the same in every theme, so these colours are too. */
export const PLAN_COLOUR: Readonly<Record<PlanKind, Color>> = {
  flight: Color.fromCssColorString("#f58be8"),
  hil: Color.fromCssColorString("#7ddcf0"),
};
/** What the board does not have yet. */
export const UNSENT_COLOUR = Color.fromCssColorString("#ffb62e");
export const ACTIVE_COLOUR = Color.WHITE;
export const EDGE_COLOUR = Color.fromCssColorString("#0a0d0f");

/** The lines of a plan, one material each: the engine draws what shares one in a single call. */
export interface PlanMaterials {
  readonly leg: Material;
  readonly unsentLeg: Material;
  readonly activeLeg: Material;
  /** What the board has, where another plan is being edited. */
  readonly oldLeg: Material;
  readonly ring: Material;
  readonly activeRing: Material;
  readonly stem: Material;
  readonly selectedStem: Material;
}

/** The real plan is drawn through, the simulator's is dashed: told apart without colours too. */
export function materialsOf(kind: PlanKind): PlanMaterials {
  const colour = PLAN_COLOUR[kind];
  const line = (of: Color): Material =>
    kind === "hil"
      ? Material.fromType(Material.PolylineDashType, {
          color: of,
          gapColor: Color.TRANSPARENT,
          dashLength: 18,
        })
      : plain(of);
  return {
    leg: line(colour),
    unsentLeg: line(UNSENT_COLOUR),
    activeLeg: Material.fromType(Material.PolylineOutlineType, {
      color: colour,
      outlineColor: ACTIVE_COLOUR,
      outlineWidth: 2,
    }),
    oldLeg: line(colour.withAlpha(0.45)),
    ring: plain(colour.withAlpha(0.7)),
    activeRing: plain(ACTIVE_COLOUR),
    stem: plain(colour.withAlpha(0.55)),
    selectedStem: plain(ACTIVE_COLOUR),
  };
}

function plain(color: Color): Material {
  return Material.fromType(Material.ColorType, { color });
}
