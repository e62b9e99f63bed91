import { type ImageryTypes, Rectangle, WebMercatorTilingScheme } from "@cesium/engine";
import type { Light } from "../../look";
import { sourceOf, VECTOR_PX } from "../../vector/VectorTiles";
import type { World } from "../../world/World";
import { coveredBy, type ImagerySource, lowestLevel } from "./imagery";
import { WorkersPictures } from "./Pictures";

/** Roads, rivers and buildings over the globe: the flat map's drawing of them, as pictures. Names are the flat map's. */
export class VectorImagery extends WorkersPictures {
  readonly tilingScheme = new WebMercatorTilingScheme();
  readonly maximumLevel = 18;
  override readonly rectangle: Rectangle;
  override readonly minimumLevel: number;
  readonly #source: ImagerySource;
  readonly #world: World;
  readonly #light: Light;

  constructor(source: ImagerySource, world: World, light: Light, onDrawn: () => void) {
    super(VECTOR_PX, onDrawn);
    const { west_deg, south_deg, east_deg, north_deg } = coveredBy(source);
    this.rectangle = Rectangle.fromDegrees(west_deg, south_deg, east_deg, north_deg);
    this.minimumLevel = lowestLevel(source);
    this.#source = source;
    this.#world = world;
    this.#light = light;
  }

  protected async ask(x: number, y: number, level: number): Promise<ImageryTypes> {
    const { url, part } = sourceOf(this.#source.url, this.#source.maximum_zoom, level, x, y);
    const drawn = await this.#world.ask<"vector">({
      kind: "vector",
      url,
      part,
      zoom: level,
      light: this.#light,
      isFlipped: true,
    });
    if (drawn === null) {
      throw new Error("no tile here");
    }
    return drawn.picture;
  }
}
