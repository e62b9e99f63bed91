import type { BudgetLimits } from "../pictureBudget";

/**
 * On slow graphics, two to five pictures a second with a third of the time between them; fewer only if a picture
 * takes longer than that, and then half of the time is left to everything else.
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
 * Without a graphics processor: four to eight pictures a second if their cost allows it. At least a third of the time
 * is free, and a picture that takes half a second is still drawn once a second.
 */
const SOFTWARE: BudgetLimits = {
  ...SLOW,
  // Believe the browser's report: the measured time of such a picture is short.
  cheap_ms: 0,
  shortest_ms: 125,
  longest_ms: 250,
};

export function globeLimits(isSoftware: boolean): BudgetLimits {
  return isSoftware ? SOFTWARE : SLOW;
}

/** Pixels of a picture without a graphics processor: while something moves, and at rest. */
const MOVING_POINTS = 220_000;
const RESTING_POINTS = 1_500_000;
/** Below the first, names are unreadable. */
const COARSEST = 0.7;
const FINEST_MOVING = 0.75;

/**
 * Device pixels per CSS pixel and side, for a picture of this size in CSS pixels drawn without a graphics processor.
 */
export function softwareScale(width: number, height: number, isMoving: boolean): number {
  const scale = Math.sqrt((isMoving ? MOVING_POINTS : RESTING_POINTS) / Math.max(1, width * height));
  return Math.max(COARSEST, Math.min(isMoving ? FINEST_MOVING : 1, scale));
}
