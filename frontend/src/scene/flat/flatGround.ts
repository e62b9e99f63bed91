import { METRES_PER_DEGREE } from "../../lib/geodesy";
import { ASPHALT, COAST, LAND, PAINT, SEA } from "../colours";
import { GRAN_CANARIA, runwayCourse } from "../globe/chart/airfields";
import type { Island } from "../globe/chart/coast";
import { overlaps, thinned } from "../globe/chart/geometry";
import {
  boxSeen,
  type FlatView,
  metresPerPixel,
  TILE_PX,
  toScreen,
  worldSize_px,
  worldX,
  worldY,
} from "./projection";
import type { Words } from "./Words";

/** Sea and islands. */
export function drawGround(
  context: CanvasRenderingContext2D,
  view: FlatView,
  islands: readonly Island[],
): void {
  context.fillStyle = SEA;
  context.fillRect(0, 0, view.width_px, view.height_px);
  const seen = boxSeen(view);
  const pixel_deg = metresPerPixel(view) / METRES_PER_DEGREE;
  context.beginPath();
  for (const { ring } of islands.filter(({ box }) => overlaps(box, seen))) {
    thinned(ring, pixel_deg / 2).forEach(([longitude_deg, latitude_deg], index) => {
      const { x, y } = toScreen(view, { latitude_deg, longitude_deg });
      if (index === 0) {
        context.moveTo(x, y);
      } else {
        context.lineTo(x, y);
      }
    });
    context.closePath();
  }
  context.fillStyle = LAND;
  context.fill();
  context.strokeStyle = COAST;
  context.lineWidth = 1.5;
  context.stroke();
}

/** The field's code stands beside it while the runway is no shorter than this on the screen, and no longer. */
const CODE_LENGTH_PX = [14, 400] as const;

/** The runways of the station's airfield, over the pictures too: those may be years old. */
export function drawRunways(context: CanvasRenderingContext2D, view: FlatView, words: Words): void {
  context.strokeStyle = ASPHALT;
  for (const { ends, width_m } of GRAN_CANARIA.runways) {
    const [from, to] = ends.map((end) => toScreen(view, end));
    if (from !== undefined && to !== undefined) {
      context.lineWidth = Math.max(2, width_m / metresPerPixel(view));
      context.beginPath();
      context.moveTo(from.x, from.y);
      context.lineTo(to.x, to.y);
      context.stroke();
    }
  }
  const [first] = GRAN_CANARIA.runways;
  const length_px = first === undefined ? 0 : runwayCourse(first).length_m / metresPerPixel(view);
  if (length_px > CODE_LENGTH_PX[0] && length_px < CODE_LENGTH_PX[1]) {
    words.write(GRAN_CANARIA.code, toScreen(view, GRAN_CANARIA), 8 + length_px * 0.22, PAINT);
  }
}

/** A layer of pictures in tiles of Web Mercator, `{z}`, `{x}` and `{y}` in its address. */
export interface FlatLayer {
  readonly url: string;
  readonly minimum_zoom: number;
  readonly maximum_zoom: number;
  readonly opacity: number;
}

/** More than a large screen shows; the oldest are given up. */
const MOST_TILES = 400;

/** The tiles of pictures that are here; what is missing is asked for once, and a place without one stays empty. */
export class FlatTiles {
  readonly #onNews: () => void;
  readonly #tiles = new Map<string, HTMLImageElement>();

  constructor(onNews: () => void) {
    this.#onNews = onNews;
  }

  draw(context: CanvasRenderingContext2D, view: FlatView, layer: FlatLayer): void {
    const zoom = Math.min(layer.maximum_zoom, Math.round(view.zoom));
    if (zoom < layer.minimum_zoom) {
      return;
    }
    const count = 2 ** zoom;
    const size_px = worldSize_px(view) / count;
    const left = worldX(view.centre.longitude_deg) * count - view.width_px / 2 / size_px;
    const top = worldY(view.centre.latitude_deg) * count - view.height_px / 2 / size_px;
    context.globalAlpha = layer.opacity;
    for (let x = Math.floor(left); (x - left) * size_px < view.width_px; x += 1) {
      for (let y = Math.max(0, Math.floor(top)); (y - top) * size_px < view.height_px && y < count; y += 1) {
        const tile = this.#tile(layer.url, zoom, ((x % count) + count) % count, y);
        if (tile.complete && tile.naturalWidth > 0) {
          // Half a pixel over its neighbours, or their seams would be seen.
          context.drawImage(tile, (x - left) * size_px, (y - top) * size_px, size_px + 0.5, size_px + 0.5);
        }
      }
    }
    context.globalAlpha = 1;
  }

  clear(): void {
    for (const tile of this.#tiles.values()) {
      tile.onload = null;
    }
    this.#tiles.clear();
  }

  #tile(url: string, z: number, x: number, y: number): HTMLImageElement {
    const address = url.replace("{z}", `${z}`).replace("{x}", `${x}`).replace("{y}", `${y}`);
    const known = this.#tiles.get(address);
    if (known !== undefined) {
      return known;
    }
    const tile = new Image(TILE_PX, TILE_PX);
    tile.onload = () => this.#onNews();
    tile.src = address;
    this.#tiles.set(address, tile);
    const oldest = this.#tiles.size > MOST_TILES ? this.#tiles.keys().next().value : undefined;
    if (oldest !== undefined) {
      this.#tiles.delete(oldest);
    }
    return tile;
  }
}
