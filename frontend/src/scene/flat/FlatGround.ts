import { GROUND, type Light } from "../look";
import { levelFor, WORLD_TILE_PX } from "../world/tiling";
import type { World } from "../world/World";
import { type FlatView, metresPerPixel, worldSize_px, worldX, worldY } from "./projection";

/** Kept beside those that are seen. */
const MOST_TILES = 160;
/** While a tile is drawn, one of up to so many levels above stands in for it. */
const MOST_ABOVE = 5;
const DEEPEST = 19;

interface TileEntry {
  picture: ImageBitmap | null;
}

/** Sea, land, coast, borders and runways under all else, in tiles that the map's worker draws. */
export class FlatGround {
  readonly #world: World;
  readonly #onNews: () => void;
  /** In the order in which they were last seen. */
  readonly #tiles = new Map<string, TileEntry>();
  #light: Light = "day";

  constructor(world: World, onNews: () => void) {
    this.#world = world;
    this.#onNews = onNews;
  }

  get light(): Light {
    return this.#light;
  }

  setLight(light: Light): void {
    if (light !== this.#light) {
      this.#light = light;
      this.clear();
      this.#onNews();
    }
  }

  draw(context: CanvasRenderingContext2D, view: FlatView, ratio: number): void {
    context.fillStyle = GROUND[this.#light].sea;
    context.fillRect(0, 0, view.width_px, view.height_px);
    const zoom = Math.max(0, Math.min(DEEPEST, Math.round(view.zoom + Math.log2(ratio))));
    const count = 2 ** zoom;
    const size_px = worldSize_px(view) / count;
    const left = worldX(view.centre.longitude_deg) * count - view.width_px / 2 / size_px;
    const top = worldY(view.centre.latitude_deg) * count - view.height_px / 2 / size_px;
    let seen = 0;
    for (let x = Math.floor(left); (x - left) * size_px < view.width_px; x += 1) {
      for (let y = Math.max(0, Math.floor(top)); y < count && (y - top) * size_px < view.height_px; y += 1) {
        seen += 1;
        const column = ((x % count) + count) % count;
        this.#drawTile(context, zoom, column, y, {
          x: (x - left) * size_px,
          y: (y - top) * size_px,
          size: size_px + 0.5,
        });
      }
    }
    this.#forget(Math.max(MOST_TILES, 2 * seen));
  }

  clear(): void {
    this.#forget(0);
  }

  #drawTile(
    context: CanvasRenderingContext2D,
    zoom: number,
    x: number,
    y: number,
    at: { readonly x: number; readonly y: number; readonly size: number },
  ): void {
    this.#ask(zoom, x, y);
    for (let above = 0; above <= Math.min(zoom, MOST_ABOVE); above += 1) {
      const picture = this.#tiles.get(keyOf(zoom - above, x >> above, y >> above))?.picture ?? null;
      if (picture !== null) {
        const part = WORLD_TILE_PX / 2 ** above;
        const from_x = (x % 2 ** above) * part;
        const from_y = (y % 2 ** above) * part;
        context.drawImage(picture, from_x, from_y, part, part, at.x, at.y, at.size, at.size);
        return;
      }
    }
  }

  #ask(level: number, x: number, y: number): void {
    const key = keyOf(level, x, y);
    const known = this.#tiles.get(key);
    if (known !== undefined) {
      this.#tiles.delete(key);
      this.#tiles.set(key, known);
      return;
    }
    const kept: TileEntry = { picture: null };
    this.#tiles.set(key, kept);
    this.#world
      .ask<"tile">({
        kind: "tile",
        tile: { projection: "mercator", level, x, y },
        light: this.#light,
        opacity: 1,
        isFlipped: false,
      })
      .then(
        (picture) => {
          if (this.#tiles.get(key) === kept) {
            kept.picture = picture;
            this.#onNews();
          } else {
            picture.close();
          }
        },
        // Asked for again when it is seen next after the oldest were forgotten; the sea stands there meanwhile.
        () => undefined,
      );
  }

  #forget(most: number): void {
    for (const [key, { picture }] of this.#tiles) {
      if (this.#tiles.size <= most) {
        break;
      }
      picture?.close();
      this.#tiles.delete(key);
    }
  }
}

function keyOf(level: number, x: number, y: number): string {
  return `${level}/${x}/${y}`;
}

/** The level whose names suit a view. */
export function nameLevel(view: FlatView) {
  return levelFor(metresPerPixel(view));
}
