import { Color, Material } from "@cesium/engine";
import type { Whose } from "../../lib/mapThing";
import { EDGE, PLAN, STRONG, UNSENT } from "../colours";
import type { LineKind } from "./shape";

export type PlanKind = Whose;

export const PLAN_COLOUR: Readonly<Record<PlanKind, Color>> = {
  flight: Color.fromCssColorString(PLAN.flight),
  hil: Color.fromCssColorString(PLAN.hil),
};
export const UNSENT_COLOUR = Color.fromCssColorString(UNSENT);
export const ACTIVE_COLOUR = Color.fromCssColorString(STRONG);
export const EDGE_COLOUR = Color.fromCssColorString(EDGE);

/** Makes the material of a kind of line: a line owns its own, and takes it along when it goes. */
export type MakeMaterial = (kind: LineKind) => Material;

/** The real plan is drawn through, the simulator's is dashed: told apart without colours too. */
export function materialsOf(plan: PlanKind): MakeMaterial {
  const colour = PLAN_COLOUR[plan];
  const line = (color: Color): Material =>
    plan === "hil"
      ? Material.fromType(Material.PolylineDashType, { color, gapColor: Color.TRANSPARENT, dashLength: 18 })
      : plain(color);
  const made: Readonly<Record<LineKind, () => Material>> = {
    leg: () => line(colour),
    unsentLeg: () => line(UNSENT_COLOUR),
    activeLeg: () =>
      Material.fromType(Material.PolylineOutlineType, {
        color: colour,
        outlineColor: ACTIVE_COLOUR,
        outlineWidth: 2,
      }),
    oldLeg: () => line(colour.withAlpha(0.45)),
    ring: () => plain(colour.withAlpha(0.7)),
    activeRing: () => plain(ACTIVE_COLOUR),
    stem: () => plain(colour.withAlpha(0.55)),
    selectedStem: () => plain(ACTIVE_COLOUR),
  };
  return (kind) => made[kind]();
}

function plain(color: Color): Material {
  return Material.fromType(Material.ColorType, { color });
}
