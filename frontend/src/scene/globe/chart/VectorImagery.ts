import {
  type Proxy as CesiumProxy,
  type Credit,
  Event,
  type ImageryLayerFeatureInfo,
  type ImageryProvider,
  type ImageryTypes,
  Rectangle,
  type TileDiscardPolicy,
  WebMercatorTilingScheme,
} from "@cesium/engine";
import { sourceOf, VECTOR_PX } from "../../vector/VectorTiles";
import type { Light } from "../../world/look";
import type { World } from "../../world/World";
import { coveredBy, type ImagerySource, lowestLevel } from "../imagery";

const DEEPEST = 18;
const MOST_DRAWING = 6;

/** Roads, rivers and buildings over the globe: the flat map's drawing of them, as pictures. Names are the flat map's. */
export class VectorImagery implements ImageryProvider {
  readonly rectangle: Rectangle;
  readonly tileWidth = VECTOR_PX;
  readonly tileHeight = VECTOR_PX;
  readonly minimumLevel: number;
  readonly maximumLevel = DEEPEST;
  readonly tilingScheme = new WebMercatorTilingScheme();
  readonly tileDiscardPolicy = undefined as unknown as TileDiscardPolicy;
  readonly errorEvent = new Event();
  readonly credit = undefined as unknown as Credit;
  readonly proxy = undefined as unknown as CesiumProxy;
  readonly hasAlphaChannel = true;
  readonly #source: ImagerySource;
  readonly #world: World;
  readonly #light: Light;
  readonly #onDrawn: () => void;
  #drawing = 0;

  constructor(source: ImagerySource, world: World, light: Light, onDrawn: () => void) {
    const { west_deg, south_deg, east_deg, north_deg } = coveredBy(source);
    this.rectangle = Rectangle.fromDegrees(west_deg, south_deg, east_deg, north_deg);
    this.minimumLevel = lowestLevel(source);
    this.#source = source;
    this.#world = world;
    this.#light = light;
    this.#onDrawn = onDrawn;
    // A missing tile is no error: the layers below show there.
    this.errorEvent.addEventListener(() => undefined);
  }

  getTileCredits(): Credit[] {
    return [];
  }

  /** Undefined: too many are being drawn; the engine asks again. */
  requestImage(x: number, y: number, level: number): Promise<ImageryTypes> | undefined {
    if (this.#drawing >= MOST_DRAWING) {
      return undefined;
    }
    this.#drawing += 1;
    const { url, part } = sourceOf(this.#source.url, this.#source.maximum_zoom, level, x, y);
    return this.#world
      .ask<"vector">({ kind: "vector", url, part, zoom: level, light: this.#light, isFlipped: true })
      .then((drawn) => {
        if (drawn === null) {
          throw new Error("no tile here");
        }
        return drawn.picture;
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
