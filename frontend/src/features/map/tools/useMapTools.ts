import type { MapTools } from "../../../scene/tools/MapTools";
import { useGlobeLayer } from "../useGlobe";

/** The globe's tools, shared by its corner and its panel. */
export function useMapTools(): MapTools | null {
  return useGlobeLayer("tools", async () => (await import("../../../scene/tools/MapTools")).MapTools);
}
