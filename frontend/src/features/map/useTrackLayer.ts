import { useEffect } from "react";
import { TRACKS } from "../../protocol/track";
import { usePage } from "../../store/hooks";
import { TRACK_KINDS } from "./trackKinds";
import { useGlobeLayer } from "./useGlobe";
import type { TrackChoices } from "./useTrackLook";

/** Draws the tracks on the globe as they are chosen to look. */
export function useTrackLayer({ colouring, range, hasCurtain, isShown }: TrackChoices): void {
  const { trackBook } = usePage();
  const layer = useGlobeLayer("track", async () => (await import("../../scene/track/TrackLayer")).TrackLayer);
  useEffect(() => {
    for (const name of TRACKS) {
      layer?.add(trackBook.points[name], TRACK_KINDS[name]);
      layer?.setVisible(trackBook.points[name], isShown[name]);
    }
    layer?.setLook({ colouring, range, hasCurtain });
  }, [layer, trackBook, colouring, range, hasCurtain, isShown]);
}
