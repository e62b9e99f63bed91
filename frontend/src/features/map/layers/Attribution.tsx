import { useTranslation } from "react-i18next";
import { useSettings } from "../../../store/hooks";
import { useFlat } from "../scenes/useFlat";
import { useMapLayers } from "./layerList";
import { stackOfLayers } from "./useGround";

/** The attributions of the visible layers, and of the map that ships with the page. */
export function Attribution() {
  const { t } = useTranslation();
  const layers = useMapLayers((known) => known.layers);
  const remembered = useSettings(({ choices }) => choices["map.layers.stack"]);
  const terrain = useSettings(({ choices }) => choices["map.layers.terrain"]);
  const { isShown: isFlat } = useFlat();
  const shown = new Set(
    stackOfLayers(layers, remembered)
      .filter(({ isOn, opacity }) => isOn && opacity > 0)
      .map(({ id }) => id),
  );
  const names = layers
    .filter(
      ({ id, attribution, problem }) =>
        problem === null && attribution !== "" && (shown.has(id) || (id === terrain && !isFlat)),
    )
    .map(({ attribution }) => attribution);
  return <p className="map-attribution">{[...new Set([...names, t("map.ground.credit")])].join(" · ")}</p>;
}
