import type { MapTools } from "../../../scene/tools/MapTools";
import { useGlobeLayer } from "../useGlobe";

/** The tools of the globe, which its corner and its panel share. */
export function useMapTools(): MapTools | null {
  return useGlobeLayer("tools", async () => (await import("../../../scene/tools/MapTools")).MapTools);
}
