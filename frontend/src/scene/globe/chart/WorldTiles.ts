import { GeographicTilingScheme, type ImageryTypes } from "@cesium/engine";
import type { Light } from "../../look";
import { WORLD_TILE_PX } from "../../world/tiling";
import type { World } from "../../world/World";
import { WorkersPictures } from "./Pictures";

/** From afar the picture of the Earth shows through: share of the chart by level, and all of it from there on. */
const OPACITIES = [0.2, 0.2, 0.25, 0.4, 0.6, 0.8];

/** The chart of the whole world, tile by tile, drawn by the map's worker. */
export class WorldTiles extends WorkersPictures {
  readonly tilingScheme = new GeographicTilingScheme();
  /** Tiles of 75 m: runways with their marks. */
  readonly maximumLevel = 18;
  readonly #world: World;
  readonly #light: Light;

  constructor(world: World, light: Light, onDrawn: () => void) {
    super(WORLD_TILE_PX, onDrawn);
    this.#world = world;
    this.#light = light;
  }

  protected ask(x: number, y: number, level: number): Promise<ImageryTypes> {
    const opacity = this.#light === "night" ? 1 : (OPACITIES[level] ?? 1);
    return this.#world.ask<"tile">({
      kind: "tile",
      tile: { projection: "geographic", level, x, y },
      light: this.#light,
      opacity,
      isFlipped: true,
    });
  }
}
