import { type Checked, isFlag, isNumber, isObject, isText, list, nullable, oneOf, shape } from "../lib/check";
import type { components } from "./api.gen";

/** Why something cannot be used: one English sentence, and its code with values for a sentence of another language. */
const problem = {
  problem: nullable(isText),
  problem_code: nullable(isText),
  problem_params: isObject,
};

const isMapLayer = shape({
  id: isText,
  name: isText,
  kind: oneOf("imagery", "terrain"),
  format: oneOf("mbtiles", "pmtiles", "quantized_mesh", "geotiff", "hgt", "online"),
  west_deg: isNumber,
  south_deg: isNumber,
  east_deg: isNumber,
  north_deg: isNumber,
  minimum_zoom: isNumber,
  maximum_zoom: isNumber,
  attribution: isText,
  bytes: isNumber,
  ...problem,
});
export type MapLayer = Checked<typeof isMapLayer>;

/** Heights that are being turned into terrain: it is no fault that they cannot be shown yet. */
export function isConverting({ problem_code }: Pick<MapLayer, "problem_code">): boolean {
  return problem_code === "map_raster_converting";
}

/** The layers that the gateway has, and where their files lie. */
export const isMapLayers = shape({ folder: isText, layers: list(isMapLayer) });

/** A file on its way into the folder. `percent` of the receiving, then of the converting. */
export const isMapImport = shape({
  id: isText,
  name: isText,
  state: oneOf("receiving", "converting", "done", "failed"),
  bytes: isNumber,
  total_bytes: nullable(isNumber),
  percent: nullable(isNumber),
  layer: nullable(isText),
  ...problem,
});
export type MapImport = Checked<typeof isMapImport>;

const isOnlineSource = shape({
  id: isText,
  name: isText,
  url: isText,
  attribution: isText,
  maximum_zoom: isNumber,
  ...problem,
});
export type OnlineSource = Checked<typeof isOnlineSource>;

/** Maps of the internet: off until somebody switches them on. */
export const isMapOnline = shape({
  enabled: isFlag,
  limit_bytes: isNumber,
  cached_bytes: isNumber,
  sources: list(isOnlineSource),
});
export type MapOnline = Checked<typeof isMapOnline>;

/** What a person chooses of it. */
export interface OnlineChoice {
  readonly enabled: boolean;
  readonly limit_bytes: number;
  readonly sources: readonly Pick<OnlineSource, "id" | "name" | "url" | "attribution" | "maximum_zoom">[];
}

/** The kinds of files that hold maps. */
export const MAP_FILES = ".mbtiles,.pmtiles,.tif,.tiff,.hgt,.zip";

type Described = components["schemas"];
/** Do not compile when the gateway describes its layers otherwise than they are checked here. */
export const layersAreAsDescribed: Described["MapLayers"] extends Checked<typeof isMapLayers> ? true : false =
  true;
export const importIsAsDescribed: Described["MapImport"] extends Checked<typeof isMapImport> ? true : false =
  true;
export const onlineIsAsDescribed: Described["OnlineState"] extends Checked<typeof isMapOnline>
  ? true
  : false = true;
