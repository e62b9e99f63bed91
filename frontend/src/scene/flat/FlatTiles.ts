import type { ImagerySource } from "../globe/chart/imagery";
import { type FlatView, TILE_PX, worldSize_px, worldX, worldY } from "./projection";

export interface FlatLayer extends ImagerySource {
  readonly opacity: number;
}

/** Kept beside those that are seen. */
const MOST_TILES = 400;

/** The tiles of pictures that are here; what is missing is asked for once, and a place without one stays empty. */
export class FlatTiles {
  readonly #onNews: () => void;
  /** In the order in which they were last seen. */
  readonly #tiles = new Map<string, HTMLImageElement>();

  constructor(onNews: () => void) {
    this.#onNews = onNews;
  }

  /** Layers from below. `other`: draws those that do not come as pictures. */
  draw(
    context: CanvasRenderingContext2D,
    view: FlatView,
    layers: readonly FlatLayer[],
    other: (layer: FlatLayer) => void = () => undefined,
  ): void {
    let seen = 0;
    for (const layer of layers) {
      if (layer.kind === "vector") other(layer);
      else seen += this.#drawLayer(context, view, layer);
    }
    // One that is seen is never given up: it would be asked for again at once, for ever.
    const most = Math.max(MOST_TILES, seen);
    for (const address of this.#tiles.keys()) {
      if (this.#tiles.size <= most) {
        break;
      }
      this.#tiles.delete(address);
    }
  }

  clear(): void {
    for (const tile of this.#tiles.values()) {
      tile.onload = null;
    }
    this.#tiles.clear();
  }

  /** How many tiles of it are seen. */
  #drawLayer(context: CanvasRenderingContext2D, view: FlatView, layer: FlatLayer): number {
    const zoom = Math.min(layer.maximum_zoom, Math.round(view.zoom));
    if (zoom < layer.minimum_zoom) {
      return 0;
    }
    const count = 2 ** zoom;
    const size_px = worldSize_px(view) / count;
    const left = worldX(view.centre.longitude_deg) * count - view.width_px / 2 / size_px;
    const top = worldY(view.centre.latitude_deg) * count - view.height_px / 2 / size_px;
    const west = Math.floor(worldX(layer.west_deg) * count);
    const east = Math.ceil(worldX(layer.east_deg) * count);
    const firstRow = Math.max(0, Math.floor(top), Math.floor(worldY(layer.north_deg) * count));
    const lastRow = Math.min(count, Math.ceil(worldY(layer.south_deg) * count));
    let seen = 0;
    context.globalAlpha = layer.opacity;
    for (let x = Math.floor(left); (x - left) * size_px < view.width_px; x += 1) {
      const column = ((x % count) + count) % count;
      if (column < west || column >= east) {
        continue;
      }
      for (let y = firstRow; (y - top) * size_px < view.height_px && y < lastRow; y += 1) {
        seen += 1;
        const tile = this.#tile(layer.url, zoom, column, y);
        if (tile.complete && tile.naturalWidth > 0) {
          // Half a pixel over its neighbours, or their seams would be seen.
          context.drawImage(tile, (x - left) * size_px, (y - top) * size_px, size_px + 0.5, size_px + 0.5);
        }
      }
    }
    context.globalAlpha = 1;
    return seen;
  }

  #tile(url: string, z: number, x: number, y: number): HTMLImageElement {
    const address = url.replace("{z}", `${z}`).replace("{x}", `${x}`).replace("{y}", `${y}`);
    const known = this.#tiles.get(address);
    if (known !== undefined) {
      this.#tiles.delete(address);
      this.#tiles.set(address, known);
      return known;
    }
    const tile = new Image(TILE_PX, TILE_PX);
    tile.onload = () => this.#onNews();
    tile.src = address;
    this.#tiles.set(address, tile);
    return tile;
  }
}
