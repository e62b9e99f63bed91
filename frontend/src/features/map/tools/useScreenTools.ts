import type { MapTools } from "../../../scene/tools/MapTools";
import { useFlat } from "../flat/useFlat";
import { useMapTools } from "./useMapTools";

/** The tools of the map that is shown; null until it can be drawn. */
export function useScreenTools(): Pick<MapTools, "measure" | "showDistance" | "showArea" | "centre"> | null {
  const onGlobe = useMapTools();
  const flat = useFlat();
  return flat.isShown ? flat.scene : onGlobe;
}
