/** Image tiles: `{z}`, `{x}` and `{y}` (from the north) in the address, Web Mercator. */
export interface ImagerySource {
  readonly url: string;
  readonly west_deg: number;
  readonly south_deg: number;
  readonly east_deg: number;
  readonly north_deg: number;
  readonly minimum_zoom: number;
  readonly maximum_zoom: number;
  /** Vector tiles are drawn by the page. */
  readonly kind?: "imagery" | "vector" | "terrain";
}

/** The square of Web Mercator ends here. */
const POLE_DEG = 85.0511;
/** With more tiles than this at once the engine would be busy for seconds, or for ever. */
const MOST_OF_LOWEST = 64;

type CoveredArea = Pick<ImagerySource, "west_deg" | "south_deg" | "east_deg" | "north_deg">;

/** The area that the source covers. An area beyond the map's edge is ignored. */
export function coveredBy({ west_deg, south_deg, east_deg, north_deg }: CoveredArea): CoveredArea {
  const south = Math.max(-POLE_DEG, south_deg);
  const north = Math.min(POLE_DEG, north_deg);
  return west_deg < east_deg && south < north
    ? { west_deg, south_deg: south, east_deg, north_deg: north }
    : { west_deg: -180, south_deg: -POLE_DEG, east_deg: 180, north_deg: POLE_DEG };
}

/**
 * The lowest level to load from the source. Its own lowest level is shown from afar too; but a source that claims
 * half of the Earth with small tiles, as many files do, is shown only from near.
 */
export function lowestLevel(source: ImagerySource): number {
  const { west_deg, south_deg, east_deg, north_deg } = coveredBy(source);
  const size_deg = 360 / 2 ** source.minimum_zoom;
  // Rows are at most as high as columns are wide.
  const tiles = Math.ceil((east_deg - west_deg) / size_deg) * Math.ceil((north_deg - south_deg) / size_deg);
  return tiles > MOST_OF_LOWEST ? 0 : source.minimum_zoom;
}
