import type { PlanScene } from "../../../scene/plan/PlanScene";
import { useGlobeLayer } from "../useGlobe";

/** The plans on the globe; null until they can be drawn. */
export function usePlanLayer(): PlanScene | null {
  return useGlobeLayer("plan", async () => (await import("../../../scene/plan/PlanScene")).PlanScene);
}
