import {
  buildModuleUrl,
  CesiumTerrainProvider,
  Color,
  EllipsoidTerrainProvider,
  ImageryLayer,
  Rectangle,
  type Scene,
  TileMapServiceImageryProvider,
  UrlTemplateImageryProvider,
} from "@cesium/engine";
import { GROUND, type Light } from "../look";
import { keptVectors, keptWorld } from "../world/World";
import { CanvasTiles } from "./chart/CanvasTiles";
import { drawGraticule } from "./chart/graticule";
import { coveredBy, type ImagerySource, lowestLevel } from "./chart/imagery";
import { VectorImagery } from "./chart/VectorImagery";
import { WorldTiles } from "./chart/WorldTiles";

/** The graticule's deepest level: tiles of 150 m. */
const GRATICULE_LEVELS = 17;
const WORLD = { west_deg: -180, south_deg: -90, east_deg: 180, north_deg: 90 };

export type { ImagerySource } from "./chart/imagery";

/** Tiles of heights above sea level: the folder of `layer.json`. */
export interface TerrainSource {
  readonly url: string;
}

/** One image layer on the globe. */
export interface ImageryHandle {
  setVisible(isVisible: boolean): void;
  /** 0: transparent, 1: opaque. */
  setOpacity(opacity: number): void;
  remove(): void;
}

/** What the layers need of the globe. */
interface DrawnOn {
  readonly scene: Scene;
  readonly requestRender: () => void;
}

/**
 * The globe's layers, from the lowest: the Earth's image, the chart of the world, other layers in the order
 * in which they were added, the graticule.
 */
export class Ground {
  readonly #globe: DrawnOn;
  readonly #natural: ImageryLayer;
  #chart: ImageryLayer;
  #light: Light = "day";
  #graticule: ImageryLayer | null = null;
  #terrain = 0;

  constructor(globe: DrawnOn) {
    this.#globe = globe;
    this.#natural = ImageryLayer.fromProviderAsync(
      TileMapServiceImageryProvider.fromUrl(buildModuleUrl("Assets/Textures/NaturalEarthII")),
    );
    this.#chart = this.#chartOf(this.#light);
    globe.scene.imageryLayers.add(this.#natural);
    globe.scene.imageryLayers.add(this.#chart);
    this.#setBare();
  }

  /** What is not yet drawn looks like the sea: the engine's own bright blue would blind at night. */
  #setBare(): void {
    this.#globe.scene.globe.baseColor = Color.fromCssColorString(GROUND[this.#light].sea);
  }

  #chartOf(light: Light): ImageryLayer {
    // Those that had to wait are asked for with the next picture.
    return new ImageryLayer(new WorldTiles(keptWorld(), light, () => this.#globe.scene.requestRender()));
  }

  /** Draw the chart for the day or for the night. */
  setLight(light: Light): void {
    if (light === this.#light) {
      return;
    }
    this.#light = light;
    const layers = this.#globe.scene.imageryLayers;
    const at = layers.indexOf(this.#chart);
    layers.remove(this.#chart, true);
    this.#chart = this.#chartOf(light);
    layers.add(this.#chart, at);
    this.#natural.show = light === "day";
    this.#setBare();
    this.#globe.requestRender();
  }

  /** Lines of latitude and longitude. */
  setGraticule(isVisible: boolean): void {
    const layers = this.#globe.scene.imageryLayers;
    if (this.#graticule !== null) {
      layers.remove(this.#graticule, true);
      this.#graticule = null;
    }
    if (isVisible) {
      this.#graticule = new ImageryLayer(
        new CanvasTiles(WORLD, GRATICULE_LEVELS, (context, box, level) => drawGraticule(context, box, level)),
      );
      layers.add(this.#graticule);
    }
    this.#globe.requestRender();
  }

  addImagery(source: ImagerySource): ImageryHandle {
    const { west_deg, south_deg, east_deg, north_deg } = coveredBy(source);
    const provider =
      source.kind === "vector"
        ? new VectorImagery(source, keptVectors(), this.#light, () => this.#globe.scene.requestRender())
        : new UrlTemplateImageryProvider({
            url: source.url,
            rectangle: Rectangle.fromDegrees(west_deg, south_deg, east_deg, north_deg),
            minimumLevel: lowestLevel(source),
            maximumLevel: source.maximum_zoom,
          });
    // A missing tile is no error: the layers below show there.
    provider.errorEvent.addEventListener(() => undefined);
    const layer = new ImageryLayer(provider);
    const layers = this.#globe.scene.imageryLayers;
    layers.add(layer, this.#graticule === null ? undefined : layers.indexOf(this.#graticule));
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

  /** Null: the ground is at sea level everywhere. Rejects if the terrain cannot be read; the old one stays. */
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
