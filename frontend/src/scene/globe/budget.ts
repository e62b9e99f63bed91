import type { BudgetLimits } from "../frameBudget";

/**
 * A frame of the globe costs tenths of a second of a processor that draws alone: then two to five are drawn in a second,
 * with a third of the time between; no fewer but where a frame takes longer than that, and as much is left to all else.
 */
export const GLOBE_LIMITS: BudgetLimits = {
  dear_ms: 45,
  cheap_ms: 20,
  shortest_ms: 200,
  longest_ms: 500,
  share: 0.35,
  held: { shortest_ms: 100, share: 0.6 },
  leastRest: 1.5,
};
