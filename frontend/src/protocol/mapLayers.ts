import type { MapLayer, OnlineSource, OnlineState } from "./guards.gen";

export type { MapImport, MapLayer, OnlineSource } from "./guards.gen";

/** What heights count from: the sea, or the ellipsoid WGS 84. */
export type Datum = NonNullable<MapLayer["datum"]>;

/** Maps of the internet: off until somebody switches them on. */
export type MapOnline = OnlineState;

/** Heights that are being turned into terrain: it is no fault that they cannot be shown yet. */
export function isConverting({ problem_code }: Pick<MapLayer, "problem_code">): boolean {
  return problem_code === "map_raster_converting";
}

/** What a person chooses of it. */
export interface OnlineChoice {
  readonly enabled: boolean;
  readonly limit_bytes: number;
  readonly sources: readonly Pick<OnlineSource, "id" | "name" | "url" | "attribution" | "maximum_zoom">[];
}

/** The kinds of files that hold maps. */
export const MAP_FILES = ".mbtiles,.pmtiles,.tif,.tiff,.hgt,.zip,.field";
