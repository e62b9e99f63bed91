import { createFields, FIELD } from "../features/field/field";
import { MAP_LAYERS } from "../features/map/layers/layerList";
import { createMapLayerActions } from "../features/map/layers/layerRequests";
import { createSurroundings, SURROUNDINGS } from "../features/map/surroundings/surroundings";
import { createMapTool, MAP_TOOL } from "../features/map/tools/mapTool";
import { createTrackEdits, TRACK_EDITS } from "../features/map/track/trackEdits";
import { TRACK_LOG } from "../features/map/track/trackLog";
import { createTrackLog } from "../features/map/track/trackRequests";
import type { Timers } from "../lib/timers";
import type { StreamEvent } from "../protocol/envelope";
import type { RequesterParts } from "../requests/asking";
import { createFieldWish, FIELD_WISH } from "../store/fieldWish";
import type { Parts } from "../store/parts";

/** What the map is made of: layers, fields that are brought before a flight, tracks, ground and fence, and what a press on it does. */
export function createMapParts(
  asking: RequesterParts,
  timers: Timers,
  report: (error: unknown) => void,
): { readonly addTo: (parts: Parts) => Parts; readonly takeEvent: (event: StreamEvent) => void } {
  const { mapLayers, takeMapEvent } = createMapLayerActions({ ...asking, timers });
  const { field, takeFieldEvent } = createFields({ ...asking, onChanged: () => mapLayers.read() });
  const { trackLog, takeTrackEvent } = createTrackLog({ rest: asking.rest, timers, report });
  const { surroundings, takeSurroundingsEvent } = createSurroundings(asking.rest);
  return {
    addTo: (parts) =>
      parts
        .with(MAP_TOOL, createMapTool())
        .with(MAP_LAYERS, mapLayers)
        .with(FIELD, field)
        .with(FIELD_WISH, createFieldWish())
        .with(TRACK_LOG, trackLog)
        .with(TRACK_EDITS, createTrackEdits(asking))
        .with(SURROUNDINGS, surroundings),
    takeEvent: (event) => {
      takeMapEvent(event);
      takeFieldEvent(event);
      takeTrackEvent(event);
      takeSurroundingsEvent(event);
    },
  };
}
