import {
  type Proxy as CesiumProxy,
  type Credit,
  Event,
  GeographicTilingScheme,
  type ImageryLayerFeatureInfo,
  type ImageryProvider,
  type ImageryTypes,
  Rectangle,
  type TileDiscardPolicy,
} from "@cesium/engine";
import type { Light } from "../../world/look";
import { WORLD_TILE_PX } from "../../world/tiling";
import type { World } from "../../world/World";

/** From afar the picture of the Earth shows through: share of the chart by level, and all of it from there on. */
const OPACITIES = [0.2, 0.2, 0.25, 0.4, 0.6, 0.8];
/** Tiles of 75 m: runways with their marks. */
const DEEPEST = 18;

/** More at once would keep the worker busy with tiles that are no longer seen. */
const MOST_DRAWING = 6;

/** The chart of the whole world, tile by tile, drawn by the map's worker. */
export class WorldTiles implements ImageryProvider {
  readonly rectangle = Rectangle.MAX_VALUE;
  readonly tileWidth = WORLD_TILE_PX;
  readonly tileHeight = WORLD_TILE_PX;
  readonly minimumLevel = 0;
  readonly maximumLevel = DEEPEST;
  readonly tilingScheme = new GeographicTilingScheme();
  readonly tileDiscardPolicy = undefined as unknown as TileDiscardPolicy;
  readonly errorEvent = new Event();
  readonly credit = undefined as unknown as Credit;
  readonly proxy = undefined as unknown as CesiumProxy;
  readonly hasAlphaChannel = true;
  readonly #world: World;
  readonly #light: Light;
  readonly #onDrawn: () => void;
  #drawing = 0;

  constructor(world: World, light: Light, onDrawn: () => void) {
    this.#world = world;
    this.#onDrawn = onDrawn;
    this.#light = light;
    // A tile that could not be read: the picture of the Earth shows there.
    this.errorEvent.addEventListener(() => undefined);
  }

  getTileCredits(): Credit[] {
    return [];
  }

  /** Undefined: too many are being drawn; the engine asks again with one of its next pictures. */
  requestImage(x: number, y: number, level: number): Promise<ImageryTypes> | undefined {
    if (this.#drawing >= MOST_DRAWING) {
      return undefined;
    }
    this.#drawing += 1;
    const opacity = this.#light === "night" ? 1 : (OPACITIES[level] ?? 1);
    return this.#world
      .ask<"tile">({
        kind: "tile",
        tile: { projection: "geographic", level, x, y },
        light: this.#light,
        opacity,
        isFlipped: true,
      })
      .finally(() => {
        this.#drawing -= 1;
        this.#onDrawn();
      });
  }

  pickFeatures(): Promise<ImageryLayerFeatureInfo[]> | undefined {
    return undefined;
  }
}
