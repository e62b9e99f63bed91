import {
  buildModuleUrl,
  CesiumTerrainProvider,
  EllipsoidTerrainProvider,
  ImageryLayer,
  Rectangle,
  TileMapServiceImageryProvider,
  UrlTemplateImageryProvider,
} from "@cesium/engine";
import type { Globe } from "./Globe";

/** What covers the whole Earth below everything else. */
export type BaseKind = "natural" | "none";

/** Pictures by tiles: `{z}`, `{x}` and `{y}` (from the north) in the address, Web Mercator. */
export interface ImagerySource {
  readonly url: string;
  readonly west_deg: number;
  readonly south_deg: number;
  readonly east_deg: number;
  readonly north_deg: number;
  readonly minimum_zoom: number;
  readonly maximum_zoom: number;
}

/** Heights over sea level by tiles: the folder that holds `layer.json`. */
export interface TerrainSource {
  readonly url: string;
}

/** One layer of pictures on the globe. */
export interface ImageryHandle {
  setVisible(isVisible: boolean): void;
  /** 0: clear, 1: covers what is below. */
  setOpacity(opacity: number): void;
  remove(): void;
}

/** What lies on the globe, from below: the Earth's picture, then the layers in the order in which they were added. */
export class Ground {
  readonly #globe: Globe;
  readonly #natural: ImageryLayer;
  #terrain = 0;

  constructor(globe: Globe) {
    this.#globe = globe;
    this.#natural = ImageryLayer.fromProviderAsync(
      TileMapServiceImageryProvider.fromUrl(buildModuleUrl("Assets/Textures/NaturalEarthII")),
    );
    globe.scene.imageryLayers.add(this.#natural);
  }

  setBase(kind: BaseKind): void {
    this.#natural.show = kind === "natural";
    this.#globe.requestRender();
  }

  addImagery(source: ImagerySource): ImageryHandle {
    const provider = new UrlTemplateImageryProvider({
      url: source.url,
      rectangle: Rectangle.fromDegrees(source.west_deg, source.south_deg, source.east_deg, source.north_deg),
      minimumLevel: source.minimum_zoom,
      maximumLevel: source.maximum_zoom,
    });
    // A place without a picture is no fault: what lies below is seen there.
    provider.errorEvent.addEventListener(() => undefined);
    const layer = new ImageryLayer(provider);
    const layers = this.#globe.scene.imageryLayers;
    layers.add(layer);
    this.#globe.requestRender();
    return {
      setVisible: (isVisible) => {
        layer.show = isVisible;
        this.#globe.requestRender();
      },
      setOpacity: (opacity) => {
        layer.alpha = opacity;
        this.#globe.requestRender();
      },
      remove: () => {
        layers.remove(layer, true);
        this.#globe.requestRender();
      },
    };
  }

  /** Null: the ground is the sea's level everywhere. Rejects where the terrain cannot be read; the old one stays. */
  async setTerrain(source: TerrainSource | null): Promise<void> {
    this.#terrain += 1;
    const asked = this.#terrain;
    const provider =
      source === null ? new EllipsoidTerrainProvider() : await CesiumTerrainProvider.fromUrl(source.url);
    if (asked === this.#terrain) {
      this.#globe.scene.terrainProvider = provider;
      this.#globe.requestRender();
    }
  }
}
