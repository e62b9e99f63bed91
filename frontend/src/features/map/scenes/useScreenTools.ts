import type { PlanScene } from "../../../scene/plan/PlanScene";
import type { MapTools } from "../../../scene/tools/MapTools";
import { useFlat } from "./useFlat";
import { useGlobeLayer } from "./useGlobe";

/** The tools of the map that is shown; null until it can be drawn. */
export function useScreenTools(): Pick<MapTools, "measure" | "showDistance" | "showArea" | "centre"> | null {
  const onGlobe = useMapTools();
  const flat = useFlat();
  return flat.isShown ? flat.scene : onGlobe;
}

/** The globe's tools, shared by its corner and its panel. */
export function useMapTools(): MapTools | null {
  return useGlobeLayer("tools", async () => (await import("../../../scene/tools/MapTools")).MapTools);
}

/** The plans on the globe; null until they can be drawn. */
export function usePlanLayer(): PlanScene | null {
  return useGlobeLayer("plan", async () => (await import("../../../scene/plan/PlanScene")).PlanScene);
}
