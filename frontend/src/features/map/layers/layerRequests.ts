import { Repeating } from "../../../lib/repeating";
import type { Timers } from "../../../lib/timers";
import type { StreamEvent } from "../../../protocol/envelope";
import { isMapImport, isMapLayers, isOnlineState } from "../../../protocol/guards.gen";
import { isConverting, type MapLayer } from "../../../protocol/mapLayers";
import { createAsking, info, type RequesterParts } from "../../../requests/asking";
import { failureMessage } from "../../../store/messages";
import {
  createMapLayers,
  forgetImport,
  type MapLayerActions,
  type MapLayerStore,
  noteImport,
} from "./layerList";

const LAYERS = "/api/v1/map/layers";
const ONLINE = "/api/v1/map/online";
const IMPORTS = "/api/v1/map/imports";
/** Time for gigabytes over a slow radio link. */
const SEND_MS = 6 * 3600_000;
/** How often to ask for the progress of a file that somebody copied into the station's folder. */
const CONVERTING_MS = 2000;

type LayerName = Pick<MapLayer, "id" | "name">;

/** The requests about map layers, with their outcome in the stores. */
export function createMapLayerActions(parts: RequesterParts & { readonly timers: Timers }): {
  readonly mapLayers: MapLayerActions;
  readonly takeMapEvent: (event: StreamEvent) => void;
} {
  const { rest, timers } = parts;
  const { run } = createAsking(parts);
  const store: MapLayerStore = createMapLayers();
  const rereading = new Repeating(timers, read, CONVERTING_MS);

  /** In how many milliseconds it is read again: only while a file is being converted. */
  async function read(): Promise<number | null> {
    const asked = rest.ask("GET", ONLINE, isOnlineState);
    const answer = await rest.ask("GET", LAYERS, isMapLayers);
    const online = await asked;
    if (online.ok) {
      store.setState({ online: online.value });
    }
    store.setState(
      answer.ok ? { ...answer.value, failure: null } : { failure: failureMessage(answer.problem) },
    );
    return answer.ok && answer.value.layers.some(isConverting) ? CONVERTING_MS : null;
  }

  function takeMapEvent({ event, data }: StreamEvent): void {
    if (event === "map_import") {
      noteImport(store, data);
      if (data.state === "done") {
        rereading.run();
      }
    }
  }

  const mapLayers: MapLayerActions = {
    store,
    read: () => rereading.run(),

    importFile: (file, asker) => {
      const path = `${IMPORTS}?name=${encodeURIComponent(file.name)}`;
      return run(asker, rest.ask("POST", path, isMapImport, file, SEND_MS), (entry) => {
        noteImport(store, entry);
        rereading.run();
        const params = { file: entry.name };
        return entry.state === "converting"
          ? { state: "confirmed", message: info("map.layers.saidConverting", params) }
          : { state: "confirmed", message: info("map.layers.saidImported", params) };
      });
    },

    cancelImport: (id, asker) =>
      run(asker, rest.ask("DELETE", `${IMPORTS}/${id}`, isMapImport), (entry) => {
        forgetImport(store, id);
        return { state: "confirmed", message: info("map.layers.saidCancelled", { file: entry.name }) };
      }),

    forgetImport: (id) => forgetImport(store, id),

    remove: ({ id, name }: LayerName, asker) =>
      run(asker, rest.ask("DELETE", `${LAYERS}/${id}`, isMapLayers), (value) => {
        store.setState(({ removed }) => ({ ...value, removed: [{ id, name }, ...removed] }));
        return { state: "confirmed", message: info("map.layers.saidRemoved", { name }) };
      }),

    chooseDatum: ({ id, name }: LayerName, datum, asker) =>
      run(asker, rest.ask("PUT", `${LAYERS}/${id}/datum`, isMapLayers, { datum }), (value) => {
        store.setState(value);
        return { state: "confirmed", message: info(`mapDatumSaid.${datum}`, { name }) };
      }),

    chooseOnline: (choice, asker) =>
      run(asker, rest.ask("PUT", ONLINE, isOnlineState, choice), (online) => {
        store.setState({ online });
        // Its sources are in the list of layers.
        rereading.run();
        const key = online.enabled ? "map.online.saidOn" : "map.online.saidOff";
        return { state: "confirmed", message: info(key) };
      }),

    clearOnline: (asker) =>
      run(asker, rest.ask("DELETE", `${ONLINE}/cache`, isOnlineState), (online) => {
        store.setState({ online });
        return { state: "confirmed", message: info("map.online.saidCleared") };
      }),

    restore: ({ id, name }: LayerName, asker) =>
      run(asker, rest.ask("POST", `${LAYERS}/${id}/restore`, isMapLayers), (value) => {
        store.setState(({ removed }) => ({ ...value, removed: removed.filter((one) => one.id !== id) }));
        return { state: "confirmed", message: info("map.layers.saidRestored", { name }) };
      }),
  };
  return { mapLayers, takeMapEvent };
}
