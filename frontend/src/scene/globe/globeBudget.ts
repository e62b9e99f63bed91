import type { BudgetLimits } from "../frameBudget";

/**
 * Where frames show that graphics are slow, two to five are drawn in a second, with a third of the time between; no
 * fewer but where a frame takes longer than that, and as much is left to all else.
 */
const SLOW: BudgetLimits = {
  dear_ms: 45,
  cheap_ms: 20,
  shortest_ms: 200,
  longest_ms: 500,
  share: 0.35,
  held: { shortest_ms: 100, share: 0.6 },
  leastRest: 1.5,
};

/**
 * Drawn by the processor alone, beside the page: four to eight in a second where a frame allows it. At least a third of
 * the time is without one, and a frame that takes half a second is still drawn each second.
 */
const SOFTWARE: BudgetLimits = {
  ...SLOW,
  // What the browser says of its graphics is believed: the clock sees displayed frames alone.
  cheap_ms: 0,
  shortest_ms: 125,
  longest_ms: 250,
};

export function globeLimits(isSoftware: boolean): BudgetLimits {
  return isSoftware ? SOFTWARE : SLOW;
}

/** Points of the picture without a graphics processor: while something moves, and once all is at rest. */
const MOVING_POINTS = 220_000;
const RESTING_POINTS = 1_500_000;
/** Coarser than the first its names cannot be read. */
const COARSEST = 0.7;
const FINEST_MOVING = 0.75;

/** Points to each side of a CSS pixel, of a picture of this size in CSS pixels that the processor draws alone. */
export function softwareScale(width: number, height: number, isMoving: boolean): number {
  const scale = Math.sqrt((isMoving ? MOVING_POINTS : RESTING_POINTS) / Math.max(1, width * height));
  return Math.max(COARSEST, Math.min(isMoving ? FINEST_MOVING : 1, scale));
}
