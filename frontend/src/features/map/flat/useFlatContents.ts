import { useMemo } from "react";
import { AIRCRAFT } from "../../../lib/aircraft";
import type { FlatContents } from "../../../scene/flat/FlatScene";
import { usePart, useSettings } from "../../../store/hooks";
import { useMapLayers } from "../layers/layerList";
import { shownLayers, stackOfLayers } from "../layers/useGround";
import { useGraticule } from "../scenes/useGraticule";
import { useCountries, useLight } from "../scenes/useGroundNames";
import { TRACK_KINDS } from "../track/trackKinds";
import { TRACK_LOG } from "../track/trackLog";
import { useTrackLook } from "../track/useTrackLook";

/** What the flat map shows beside the plans: the same layers and tracks that are chosen for the globe. */
export function useFlatContents(): FlatContents {
  const trackLog = usePart(TRACK_LOG);
  const { colouring, range, isShown } = useTrackLook();
  const graticule = useGraticule();
  const light = useLight();
  const countries = useCountries();
  const known = useMapLayers((all) => all.layers);
  const remembered = useSettings(({ choices }) => choices["map.layers.stack"]);
  const layers = useMemo(
    () => shownLayers(known, stackOfLayers(known, remembered)).reverse(),
    [known, remembered],
  );
  const tracks = useMemo(
    () =>
      AIRCRAFT.filter((name) => isShown[name])
        // Drawing order: the last is on top.
        .sort((one, other) => TRACK_KINDS[one].rank - TRACK_KINDS[other].rank)
        .map((name) => ({
          points: trackLog.points[name],
          look: { ...TRACK_KINDS[name], colouring, range },
        })),
    [isShown, trackLog, colouring, range],
  );
  return useMemo(
    () => ({ layers, tracks, graticule, light, countries }),
    [layers, tracks, graticule, light, countries],
  );
}
