import { Color } from "@cesium/engine";
import type { Aircraft } from "../../lib/aircraft";
import { EDGE, PLAN, STRONG, UNSENT } from "../colours";
import type { LineKind } from "../legs/shape";
import type { LineLook } from "../ribbon/RibbonLines";

export const PLAN_COLOUR: Readonly<Record<Aircraft, Color>> = {
  flight: Color.fromCssColorString(PLAN.flight),
  hil: Color.fromCssColorString(PLAN.hil),
};
export const UNSENT_COLOUR = Color.fromCssColorString(UNSENT);
export const ACTIVE_COLOUR = Color.fromCssColorString(STRONG);
export const EDGE_COLOUR = Color.fromCssColorString(EDGE);
const DASH_PX = 9;

/** The style of each kind of line. The real plan is solid, the simulator's dashed: told apart without colours too. */
export function looksOf(plan: Aircraft): Readonly<Record<LineKind, LineLook>> {
  const colour = PLAN_COLOUR[plan];
  const dashes = plan === "hil" && { dash_px: DASH_PX };
  return {
    leg: { colour, width_px: 3, ...dashes },
    unsentLeg: { colour: UNSENT_COLOUR, width_px: 3, ...dashes },
    activeLeg: { colour, width_px: 8, edge: { colour: ACTIVE_COLOUR, width_px: 1.5 } },
    oldLeg: { colour: colour.withAlpha(0.45), width_px: 2, ...dashes },
    turn: { colour: colour.withAlpha(0.8), width_px: 2 },
    ring: { colour: colour.withAlpha(0.7), width_px: 1.5 },
    activeRing: { colour: ACTIVE_COLOUR, width_px: 3 },
    stem: { colour: colour.withAlpha(0.55), width_px: 1.5 },
    selectedStem: { colour: ACTIVE_COLOUR, width_px: 4 },
  };
}
