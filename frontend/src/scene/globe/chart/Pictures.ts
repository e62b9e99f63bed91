import {
  type Proxy as CesiumProxy,
  type Credit,
  Event,
  type ImageryLayerFeatureInfo,
  type ImageryProvider,
  type ImageryTypes,
  Rectangle,
  type TileDiscardPolicy,
  type TilingScheme,
} from "@cesium/engine";

/** More at once would keep the worker busy with tiles that are no longer seen. */
const MOST_DRAWING = 6;

/** What the engine asks of pictures that are made here, tile by tile. */
export abstract class Pictures implements ImageryProvider {
  abstract readonly tilingScheme: TilingScheme;
  abstract readonly maximumLevel: number;
  readonly rectangle: Rectangle = Rectangle.MAX_VALUE;
  readonly minimumLevel: number = 0;
  readonly tileWidth: number;
  readonly tileHeight: number;
  readonly tileDiscardPolicy = undefined as unknown as TileDiscardPolicy;
  readonly errorEvent = new Event();
  readonly credit = undefined as unknown as Credit;
  readonly proxy = undefined as unknown as CesiumProxy;
  readonly hasAlphaChannel = true;

  constructor(size_px: number) {
    this.tileWidth = size_px;
    this.tileHeight = size_px;
    // A tile that is missing or could not be read is no error: what lies below shows there.
    this.errorEvent.addEventListener(() => undefined);
  }

  abstract requestImage(x: number, y: number, level: number): Promise<ImageryTypes> | undefined;

  getTileCredits(): Credit[] {
    return [];
  }

  pickFeatures(): Promise<ImageryLayerFeatureInfo[]> | undefined {
    return undefined;
  }
}

/** Pictures that the map's worker draws, a few at a time. `onDrawn` is called after each, also after one that failed. */
export abstract class WorkersPictures extends Pictures {
  readonly #onDrawn: () => void;
  #drawing = 0;

  constructor(size_px: number, onDrawn: () => void) {
    super(size_px);
    this.#onDrawn = onDrawn;
  }

  protected abstract ask(x: number, y: number, level: number): Promise<ImageryTypes>;

  /** Undefined: too many are being drawn; the engine asks again with one of its next pictures. */
  requestImage(x: number, y: number, level: number): Promise<ImageryTypes> | undefined {
    if (this.#drawing >= MOST_DRAWING) {
      return undefined;
    }
    this.#drawing += 1;
    return this.ask(x, y, level).finally(() => {
      this.#drawing -= 1;
      this.#onDrawn();
    });
  }
}
