import type { BudgetLimits } from "../frameBudget";

/** Where a frame is dear some ten are drawn in a second, with a quarter of the time between. */
const LIMITS: BudgetLimits = {
  dear_ms: 45,
  cheap_ms: 20,
  shortest_ms: 80,
  longest_ms: 250,
  share: 0.25,
  held: { shortest_ms: 40, share: 0.5 },
  leastRest: 2,
};

/**
 * What the browser says of its graphics is believed: without a graphics processor these frames are cheap for the clock,
 * which sees displayed frames alone, and dear for the processor. Where one is only slow, frames tell.
 */
export function stageLimits(isSoftware: boolean): BudgetLimits {
  return isSoftware ? { ...LIMITS, cheap_ms: 0 } : LIMITS;
}

/** Points of the picture without a graphics processor: while it moves, and once it rests. */
const MOVING_POINTS = 200_000;
const RESTING_POINTS = 4_000_000;
const COARSEST = 0.6;
const FINEST = 2;

/**
 * Points to each side of a CSS pixel, of a picture of this size in CSS pixels. While it moves no finer than the page,
 * without smooth edges; at rest finer than the page, which smooths them.
 */
export function softwareRatio(width: number, height: number, isMoving: boolean): number {
  const ratio = Math.sqrt((isMoving ? MOVING_POINTS : RESTING_POINTS) / (width * height));
  return isMoving ? Math.max(COARSEST, Math.min(1, ratio)) : Math.max(1, Math.min(FINEST, ratio));
}
