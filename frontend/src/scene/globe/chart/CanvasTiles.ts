import { GeographicTilingScheme, type ImageryTypes, Rectangle } from "@cesium/engine";
import { type Box, tileBox } from "../../world/geometry";
import { Pictures } from "./Pictures";

const SIZE_PX = 256;
/** Draws the content of a box onto an empty square canvas. */
export type DrawTile = (context: CanvasRenderingContext2D, box: Box, level: number) => void;

/** Images that the page draws itself, tile by tile, on the globe's request. */
export class CanvasTiles extends Pictures {
  readonly tilingScheme = new GeographicTilingScheme();
  override readonly rectangle: Rectangle;
  readonly maximumLevel: number;
  readonly #draw: DrawTile;

  constructor(box: Box, maximumLevel: number, draw: DrawTile) {
    super(SIZE_PX);
    this.rectangle = Rectangle.fromDegrees(box.west_deg, box.south_deg, box.east_deg, box.north_deg);
    this.maximumLevel = maximumLevel;
    this.#draw = draw;
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
}
