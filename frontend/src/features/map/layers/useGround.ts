import { useEffect, useMemo, useState } from "react";
import type { Datum, MapLayer } from "../../../protocol/mapLayers";
import type { ShownLayer } from "../../../scene/tools/LayerStack";
import { usePage, useSettings } from "../../../store/hooks";
import { choose } from "../../../store/settings";
import { useGlobeLayer } from "../scenes/useGlobe";
import { useMapLayers } from "./layerList";
import { movedLayer, rememberedStack, type StackLayer, stackOf, withLayer } from "./mapStack";

const STACK = "map.layers.stack";
const TERRAIN = "map.layers.terrain";
const PATH = "/api/v1/map/layers";

export interface GroundChoice {
  /** The image layers from the topmost down. */
  readonly stack: readonly StackLayer[];
  readonly layerOf: (id: string) => MapLayer | undefined;
  readonly change: (id: string, change: Partial<Omit<StackLayer, "id">>) => void;
  readonly move: (id: string, by: -1 | 1) => void;
  /** All terrains, including those that cannot be shown or not yet. */
  readonly terrains: readonly MapLayer[];
  readonly terrain: string | null;
  readonly terrainFailed: boolean;
  readonly chooseTerrain: (id: string | null) => void;
}

/** The layers in the user's order: stored in this browser, and shown on the globe. */
export function useGround(): GroundChoice {
  const { settings } = usePage();
  const layers = useMapLayers((known) => known.layers);
  const remembered = useSettings(({ choices }) => choices[STACK]);
  const wanted = useSettings(({ choices }) => choices[TERRAIN] ?? "");
  const stack = useMemo(() => stackOfLayers(layers, remembered), [layers, remembered]);
  const terrains = layers.filter(({ kind }) => kind === "terrain");
  const terrain = terrains.some(({ id, problem }) => id === wanted && problem === null) ? wanted : null;
  const layerOf = (id: string): MapLayer | undefined => layers.find((layer) => layer.id === id);
  const put = (next: readonly StackLayer[]): void =>
    choose(settings, STACK, rememberedStack(next, remembered));
  const terrainFailed = useOnGlobe(layers, stack, terrain, layerOf(terrain ?? "")?.datum ?? null);
  return {
    stack,
    layerOf,
    change: (id, change) => put(withLayer(stack, id, change)),
    move: (id, by) => put(movedLayer(stack, id, by)),
    terrains,
    terrain,
    terrainFailed,
    chooseTerrain: (id) => choose(settings, TERRAIN, id ?? ""),
  };
}

export function stackOfLayers(
  layers: readonly MapLayer[],
  remembered: string | undefined,
): readonly StackLayer[] {
  const imagery = layers.filter(({ kind }) => kind !== "terrain");
  return stackOf(
    imagery.map(({ id, format }) => ({ id, isOnByItself: format !== "online" })),
    remembered,
  );
}

/** The visible layers from the topmost down, with the addresses of their tiles. */
export function shownLayers(layers: readonly MapLayer[], stack: readonly StackLayer[]): ShownLayer[] {
  return stack.flatMap(({ id, isOn, opacity }) => {
    const layer = layers.find((one) => one.id === id);
    return layer !== undefined && isOn && layer.problem === null
      ? [{ ...layer, opacity, url: `${PATH}/${id}/tiles/{z}/{x}/{y}` }]
      : [];
  });
}

/** Shows the layers on the globe; returns whether the terrain could not be read. */
function useOnGlobe(
  layers: readonly MapLayer[],
  stack: readonly StackLayer[],
  terrain: string | null,
  datum: Datum | null,
): boolean {
  const laid = useGlobeLayer(
    "layers",
    async () => (await import("../../../scene/tools/LayerStack")).LayerStack,
  );
  const [failed, setFailed] = useState<string | null>(null);
  useEffect(() => {
    laid?.show(shownLayers(layers, stack));
  }, [laid, layers, stack]);
  // Another datum makes other ground of the same set.
  // biome-ignore lint/correctness/useExhaustiveDependencies: the station converts, its address stays the same
  useEffect(() => {
    setFailed(null);
    laid?.showTerrain(terrain === null ? null : `${PATH}/${terrain}/terrain`).catch(() => setFailed(terrain));
  }, [laid, terrain, datum]);
  return failed !== null && failed === terrain;
}
