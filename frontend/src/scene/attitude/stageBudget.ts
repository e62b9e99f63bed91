import type { BudgetLimits } from "../pictureBudget";

/** Slow graphics draw some ten pictures a second, with a quarter of the time between them. */
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
 * If the browser reports no graphics processor, believe it: the measured time of such a picture is short, but it
 * costs the processor. If there is a slow one, the measured times tell.
 */
export function stageLimits(isSoftware: boolean): BudgetLimits {
  return isSoftware ? { ...LIMITS, cheap_ms: 0 } : LIMITS;
}

/** Pixels of a picture without a graphics processor: while it moves, and at rest. */
const MOVING_POINTS = 200_000;
const RESTING_POINTS = 4_000_000;
const COARSEST = 0.6;
const FINEST = 2;

/**
 * Device pixels per CSS pixel and side, for a picture of this size in CSS pixels. While it moves no finer than the
 * page, without smooth edges; at rest finer, which smooths them.
 */
export function softwareRatio(width: number, height: number, isMoving: boolean): number {
  const ratio = Math.sqrt((isMoving ? MOVING_POINTS : RESTING_POINTS) / (width * height));
  return isMoving ? Math.max(COARSEST, Math.min(1, ratio)) : Math.max(1, Math.min(FINEST, ratio));
}
