import type { ShownText } from "../labels/LabelSheet";
import type { Light } from "../look";
import { sourceOf } from "../vector/VectorTiles";
import type { DrawnVector } from "../world/messages";
import type { World } from "../world/World";
import type { FlatLayer } from "./FlatTiles";
import { type FlatView, worldSize_px, worldX, worldY } from "./projection";

const MOST_TILES = 120;
const DEEPEST = 19;
/** Below towns and airfields: what they are called matters more. */
const RANK = 8;
const INK: Readonly<Record<Light, Readonly<Record<"road" | "water", string>>>> = {
  day: { road: "#fff3d0", water: "#c4e6ff" },
  night: { road: "#b5ab8c", water: "#7fa6c4" },
};
const FONT = '500 11px "Inter Variable", system-ui, sans-serif';
const NAMES_FROM_ZOOM = 11;

interface VectorEntry {
  drawn: DrawnVector | null;
}

interface Spot {
  readonly x: number;
  readonly y: number;
  readonly size_px: number;
}

/** Roads, rivers and buildings of a field's pack, drawn by a worker tile by tile; their names go to the other texts. */
export class FlatVector {
  readonly #world: () => World;
  readonly #onNews: () => void;
  readonly #tiles = new Map<string, VectorEntry>();
  #names: ShownText[] = [];

  constructor(world: () => World, onNews: () => void) {
    this.#world = world;
    this.#onNews = onNews;
  }

  /** The names in the picture that was drawn last. */
  takeNames(): readonly ShownText[] {
    const names = this.#names;
    this.#names = [];
    return names;
  }

  draw(context: CanvasRenderingContext2D, view: FlatView, layer: FlatLayer, light: Light): void {
    const zoom = Math.min(DEEPEST, Math.round(view.zoom));
    if (zoom < layer.minimum_zoom) {
      return;
    }
    const count = 2 ** zoom;
    const size_px = worldSize_px(view) / count;
    const left = worldX(view.centre.longitude_deg) * count - view.width_px / 2 / size_px;
    const top = worldY(view.centre.latitude_deg) * count - view.height_px / 2 / size_px;
    const west = Math.floor(worldX(layer.west_deg) * count);
    const east = Math.ceil(worldX(layer.east_deg) * count);
    const last = Math.ceil(worldY(layer.south_deg) * count);
    context.globalAlpha = layer.opacity;
    let seen = 0;
    for (let x = Math.floor(left); (x - left) * size_px < view.width_px; x += 1) {
      const column = ((x % count) + count) % count;
      if (column < west || column >= east) continue;
      const first = Math.max(0, Math.floor(top), Math.floor(worldY(layer.north_deg) * count));
      for (let y = first; y < last && (y - top) * size_px < view.height_px; y += 1) {
        seen += 1;
        const at = { x: (x - left) * size_px, y: (y - top) * size_px, size_px };
        this.#drawTile(context, this.#tile(layer, zoom, column, y, light), at, zoom, light);
      }
    }
    context.globalAlpha = 1;
    this.#forget(Math.max(MOST_TILES, 2 * seen));
  }

  clear(): void {
    this.#forget(0);
  }

  #drawTile(
    context: CanvasRenderingContext2D,
    { drawn }: VectorEntry,
    at: Spot,
    zoom: number,
    light: Light,
  ): void {
    if (drawn === null) {
      return;
    }
    context.drawImage(drawn.picture, at.x, at.y, at.size_px + 0.5, at.size_px + 0.5);
    if (zoom < NAMES_FROM_ZOOM) {
      return;
    }
    for (const { text, kind, rank, x, y } of drawn.names) {
      this.#names.push({
        key: `v${kind}${text}`,
        text,
        font: FONT,
        colour: INK[light][kind],
        rank: RANK + rank,
        at: { x: at.x + x * at.size_px, y: at.y + y * at.size_px },
        away_px: 0,
        isSought: false,
      });
    }
  }

  #tile(layer: FlatLayer, zoom: number, x: number, y: number, light: Light): VectorEntry {
    const key = `${light} ${layer.url} ${zoom}/${x}/${y}`;
    const known = this.#tiles.get(key);
    if (known !== undefined) {
      this.#tiles.delete(key);
      this.#tiles.set(key, known);
      return known;
    }
    const kept: VectorEntry = { drawn: null };
    this.#tiles.set(key, kept);
    const { url, part } = sourceOf(layer.url, layer.maximum_zoom, zoom, x, y);
    this.#world()
      .ask<"vector">({ kind: "vector", url, part, zoom, light, isFlipped: false })
      .then(
        (drawn) => {
          if (this.#tiles.get(key) === kept) {
            // Names are in shares of the source's tile; the picture shows a part of it.
            kept.drawn =
              drawn === null
                ? null
                : {
                    picture: drawn.picture,
                    names: drawn.names.map((name) => ({
                      ...name,
                      x: (name.x - part.left) / part.share,
                      y: (name.y - part.top) / part.share,
                    })),
                  };
            this.#onNews();
          } else {
            drawn?.picture.close();
          }
        },
        // Not a vector tile, or not read: the place stays empty until the map forgets it.
        () => undefined,
      );
    return kept;
  }

  #forget(most: number): void {
    for (const [key, { drawn }] of this.#tiles) {
      if (this.#tiles.size <= most) {
        break;
      }
      drawn?.picture.close();
      this.#tiles.delete(key);
    }
  }
}
