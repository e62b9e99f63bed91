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
import { type Box, tileBox } from "./geometry";

const SIZE_PX = 256;
/** Draws the content of a box onto an empty square canvas. */
export type DrawTile = (context: CanvasRenderingContext2D, box: Box, level: number) => void;

/** Images that the page draws itself, tile by tile, on the globe's request. */
export class CanvasTiles implements ImageryProvider {
  readonly rectangle: Rectangle;
  readonly tileWidth = SIZE_PX;
  readonly tileHeight = SIZE_PX;
  readonly minimumLevel = 0;
  readonly maximumLevel: number;
  readonly tilingScheme = new GeographicTilingScheme();
  readonly tileDiscardPolicy = undefined as unknown as TileDiscardPolicy;
  readonly errorEvent = new Event();
  readonly credit = undefined as unknown as Credit;
  readonly proxy = undefined as unknown as CesiumProxy;
  readonly hasAlphaChannel = true;
  readonly #draw: DrawTile;

  constructor(box: Box, maximumLevel: number, draw: DrawTile) {
    this.rectangle = Rectangle.fromDegrees(box.west_deg, box.south_deg, box.east_deg, box.north_deg);
    this.maximumLevel = maximumLevel;
    this.#draw = draw;
  }

  getTileCredits(): Credit[] {
    return [];
  }

  requestImage(x: number, y: number, level: number): Promise<ImageryTypes> | undefined {
    const canvas = document.createElement("canvas");
    canvas.width = SIZE_PX;
    canvas.height = SIZE_PX;
    const context = canvas.getContext("2d");
    if (context === null) {
      return undefined;
    }
    this.#draw(context, tileBox(level, x, y), level);
    return Promise.resolve(canvas);
  }

  pickFeatures(): Promise<ImageryLayerFeatureInfo[]> | undefined {
    return undefined;
  }
}
