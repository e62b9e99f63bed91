import { isNumber, isObject, isText } from "../../../lib/check";
import type { Position } from "../../../lib/geodesy";
import type { Heights } from "../../../lib/planProfile";
import { readTerrainMesh, type TerrainMesh } from "../../../lib/terrainMesh";
import type { MapLayer } from "../../../protocol/mapLayers";

const PATH = "/api/v1/map/layers";
/** Most tiles for one profile: a longer plan is looked at more coarsely. */
const MOST_TILES = 48;
/** A tile that is not there is looked for so many levels higher. */
const PARENTS = 6;
const MOST_KEPT = 128;

interface Scheme {
  readonly isFromNorth: boolean;
  readonly maximum: number;
}

/** Asks the station for terrain; an answer that is not there is null. */
export type FetchTerrain = (path: string) => Promise<Response>;

/** The heights of the ground that the station knows, by the tiles that the globe is drawn with. */
export class TerrainHeights {
  readonly #fetch: FetchTerrain;
  readonly #meshes = new Map<string, Promise<TerrainMesh | null>>();
  readonly #schemes = new Map<string, Promise<Scheme | null>>();

  constructor(fetchTerrain: FetchTerrain) {
    this.#fetch = fetchTerrain;
  }

  /** Metres above the sea below each place, from the first of these terrains that covers it; null: not known. */
  async at(places: readonly Position[], layers: readonly MapLayer[]): Promise<Heights> {
    let found: Heights = places.map(() => null);
    for (const layer of layers) {
      const missing = places.flatMap((place, index) =>
        found[index] === null && covers(layer, place) ? [{ place, index }] : [],
      );
      const scheme = missing.length === 0 ? null : await this.#scheme(layer.id);
      if (scheme !== null) {
        const heights = await this.#ofLayer(
          layer,
          scheme,
          missing.map(({ place }) => place),
        );
        const next = [...found];
        for (const [nth, { index }] of missing.entries()) {
          next[index] = heights[nth] ?? null;
        }
        found = next;
      }
    }
    return found;
  }

  #ofLayer(layer: MapLayer, scheme: Scheme, places: readonly Position[]): Promise<Heights> {
    let zoom = scheme.maximum;
    const tiles = (): number => new Set(places.map((place) => tileOf(zoom, place).join())).size;
    while (zoom > 0 && tiles() > MOST_TILES) {
      zoom -= 1;
    }
    return Promise.all(places.map((place) => this.#height(layer, scheme, zoom, place)));
  }

  async #height(layer: MapLayer, scheme: Scheme, zoom: number, place: Position): Promise<number | null> {
    for (let level = zoom; level >= Math.max(0, zoom - PARENTS); level -= 1) {
      const [column, row] = tileOf(level, place);
      const mesh = await this.#mesh(layer, level, column, scheme.isFromNorth ? 2 ** level - 1 - row : row);
      if (mesh !== null) {
        const size_deg = 180 / 2 ** level;
        return mesh.heightAt(
          (place.longitude_deg + 180) / size_deg - column,
          (place.latitude_deg + 90) / size_deg - row,
        );
      }
    }
    return null;
  }

  #mesh({ id, datum }: MapLayer, zoom: number, column: number, row: number): Promise<TerrainMesh | null> {
    const tile = `${PATH}/${encodeURIComponent(id)}/terrain/${zoom}/${column}/${row}.terrain`;
    // Another datum makes other heights of the same set, here and in the browser's own store.
    const path = datum === "ellipsoidal" ? `${tile}?v=${datum}` : tile;
    const known = this.#meshes.get(path);
    if (known !== undefined) {
      return known;
    }
    const asked = this.#fetch(path).then(
      async (answer) => (answer.status === 200 ? readTerrainMesh(await answer.arrayBuffer()) : null),
      () => {
        // A station that does not answer now may answer later.
        this.#meshes.delete(path);
        return null;
      },
    );
    this.#meshes.set(path, asked);
    const [oldest] = this.#meshes.keys();
    if (this.#meshes.size > MOST_KEPT && oldest !== undefined) {
      this.#meshes.delete(oldest);
    }
    return asked;
  }

  #scheme(id: string): Promise<Scheme | null> {
    const known = this.#schemes.get(id);
    if (known !== undefined) {
      return known;
    }
    const asked = this.#fetch(`${PATH}/${encodeURIComponent(id)}/terrain/layer.json`).then(
      async (answer) => schemeOf(answer.ok ? await answer.json() : null),
      () => {
        this.#schemes.delete(id);
        return null;
      },
    );
    this.#schemes.set(id, asked);
    return asked;
  }
}

function schemeOf(contents: unknown): Scheme | null {
  if (!isObject(contents) || (isText(contents["projection"]) && contents["projection"] !== "EPSG:4326")) {
    return null;
  }
  const { scheme, maxzoom } = contents;
  return { isFromNorth: scheme !== undefined && scheme !== "tms", maximum: isNumber(maxzoom) ? maxzoom : 0 };
}

/** Column from the west and row from the south. */
function tileOf(zoom: number, { latitude_deg, longitude_deg }: Position): readonly [number, number] {
  const size_deg = 180 / 2 ** zoom;
  const column = Math.floor((longitude_deg + 180) / size_deg);
  const row = Math.floor((latitude_deg + 90) / size_deg);
  return [Math.min(2 ** (zoom + 1) - 1, column), Math.min(2 ** zoom - 1, row)];
}

export function covers(layer: MapLayer, { latitude_deg, longitude_deg }: Position): boolean {
  return (
    longitude_deg >= layer.west_deg &&
    longitude_deg <= layer.east_deg &&
    latitude_deg >= layer.south_deg &&
    latitude_deg <= layer.north_deg
  );
}
