import { createFields, FIELD } from "../features/field/field";
import { MAP_LAYERS } from "../features/map/layers/layerList";
import { createMapLayerActions } from "../features/map/layers/layerRequests";
import type { Timers } from "../lib/timers";
import type { StreamEvent } from "../protocol/envelope";
import type { AskingParts } from "../requests/asking";
import type { Parts } from "../store/parts";

/** What the maps show beyond the page's own world: layers, and fields that are brought before a flight. */
export function createGround(parts: AskingParts & { readonly timers: Timers }): {
  readonly addTo: (page: Parts) => Parts;
  readonly takeMapEvent: (event: StreamEvent) => void;
} {
  const { mapLayers, takeMapEvent } = createMapLayerActions(parts);
  const { field, takeFieldEvent } = createFields({ ...parts, onChanged: () => void mapLayers.read() });
  return {
    addTo: (page) => page.with(MAP_LAYERS, mapLayers).with(FIELD, field),
    takeMapEvent: (event) => {
      takeMapEvent(event);
      takeFieldEvent(event);
    },
  };
}
