import { CAMERA_CHOICE } from "../../lib/mapCamera";
import type { PlaceInSpace } from "../../scene/tools/MapTools";
import { usePage } from "../../store/hooks";
import { choose } from "../../store/settings";
import { FOLLOW_CHOICE, useFlat } from "./scenes/useFlat";
import { useMapTools } from "./scenes/useScreenTools";

/** Shows all of these places on the map that is shown, which follows nothing then. */
export function useLookAt(): (places: readonly PlaceInSpace[]) => void {
  const { settings } = usePage();
  const flat = useFlat();
  const globe = useMapTools();
  return (places) => {
    if (places.length === 0) {
      return;
    }
    if (flat.isShown) {
      choose(settings, FOLLOW_CHOICE, "off");
      flat.scene?.lookAt(places);
    } else {
      choose(settings, CAMERA_CHOICE, "free");
      globe?.lookAt(places);
    }
  };
}
