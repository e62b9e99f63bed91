import { useEffect, useMemo, useState } from "react";
import type { Waypoint } from "../../../lib/plan";
import {
  type Clearance,
  clearanceOf,
  type Heights,
  type ProfilePlace,
  profilePlaces,
} from "../../../lib/planProfile";
import { useSettings } from "../../../store/hooks";
import { useMapLayers } from "../layers/layerList";
import { covers, TerrainHeights } from "./terrainHeights";

/** A ridge between two places is missed only if it is narrower than this, metres. */
const STEP_M = 60;
const MOST_PLACES = 400;
const CLEARANCE_CHOICE = "plans.clearance_ft";
const USUAL_CLEARANCE_FT = 300;

const terrain = new TerrainHeights((path) => fetch(path));

export interface Profile {
  readonly places: readonly ProfilePlace[];
  /** One for each place; null while they are asked for. */
  readonly heights: Heights | null;
  readonly clearance: Clearance | null;
  readonly wanted_ft: number;
  /** The station has heights of some ground. */
  readonly hasTerrain: boolean;
  /** Nobody has said what the heights of some of this ground count from. */
  readonly hasUnknownDatum: boolean;
}

export { CLEARANCE_CHOICE };

/** A plan over the ground that the station knows. */
export function useProfile(waypoints: readonly Waypoint[]): Profile {
  const all = useMapLayers((known) => known.layers);
  const chosen = useSettings(({ choices }) => choices["map.layers.terrain"]);
  const wanted_ft = useSettings(({ choices }) => clearanceOfChoice(choices[CLEARANCE_CHOICE]));
  const layers = useMemo(
    () =>
      all
        .filter(({ kind, problem }) => kind === "terrain" && problem === null)
        .sort((one, other) => Number(other.id === chosen) - Number(one.id === chosen)),
    [all, chosen],
  );
  const places = useMemo(() => profilePlaces(waypoints, STEP_M, MOST_PLACES), [waypoints]);
  const [found, setFound] = useState<{ of: readonly ProfilePlace[]; heights: Heights } | null>(null);
  useEffect(() => {
    let isWanted = true;
    void terrain.at(places, layers).then((heights) => isWanted && setFound({ of: places, heights }));
    return () => {
      isWanted = false;
    };
  }, [places, layers]);
  const heights = found?.of === places ? found.heights : null;
  const clearance = useMemo(
    () => (heights === null ? null : clearanceOf(places, heights, wanted_ft)),
    [places, heights, wanted_ft],
  );
  const hasUnknownDatum = layers.some(
    (layer) => layer.datum === null && places.some((place) => covers(layer, place)),
  );
  return { places, heights, clearance, wanted_ft, hasTerrain: layers.length > 0, hasUnknownDatum };
}

function clearanceOfChoice(choice: string | undefined): number {
  const value = Number(choice ?? USUAL_CLEARANCE_FT);
  return Number.isFinite(value) && value >= 0 ? value : USUAL_CLEARANCE_FT;
}
