import { useEffect } from "react";
import { AIRCRAFT } from "../../../lib/aircraft";
import { useIsPast, usePart } from "../../../store/hooks";
import { useGlobeLayer } from "../scenes/useGlobe";
import { TRACK_KINDS } from "./trackKinds";
import { TRACK_LOG } from "./trackLog";
import type { TrackChoices } from "./useTrackLook";

/** Draws the tracks on the globe in the chosen style. */
export function useTrackLayer({ colouring, range, hasCurtain, isShown }: TrackChoices): void {
  const trackLog = usePart(TRACK_LOG);
  const isPast = useIsPast();
  const layer = useGlobeLayer(
    "track",
    async () => (await import("../../../scene/track/TrackLayer")).TrackLayer,
  );
  useEffect(() => {
    for (const name of AIRCRAFT) {
      layer?.add(trackLog.points[name], TRACK_KINDS[name]);
      layer?.setVisible(trackLog.points[name], isShown[name]);
    }
    layer?.setLook({ colouring, range, hasCurtain });
  }, [layer, trackLog, colouring, range, hasCurtain, isShown]);
  // The globe outlives the tab and the vehicle that is shown: tracks of another one must not stay on it.
  useEffect(
    () => () => {
      for (const name of AIRCRAFT) {
        if (isPast) {
          layer?.remove(trackLog.points[name]);
        } else {
          layer?.setVisible(trackLog.points[name], false);
        }
      }
    },
    [layer, trackLog, isPast],
  );
}
