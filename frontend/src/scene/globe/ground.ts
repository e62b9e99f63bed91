import {
  buildModuleUrl,
  CesiumTerrainProvider,
  EllipsoidTerrainProvider,
  ImageryLayer,
  Rectangle,
  TileMapServiceImageryProvider,
  UrlTemplateImageryProvider,
} from "@cesium/engine";
import { GRAN_CANARIA } from "./chart/airfields";
import { CanvasTiles } from "./chart/CanvasTiles";
import { CHART, drawCoast, fadeBorder, type Island, needsFade, readIslands } from "./chart/coast";
import { type CompassLetters, drawGraticule } from "./chart/graticule";
import { drawAirfield } from "./chart/runways";
import type { Globe } from "./Globe";
import { coveredBy, type ImagerySource, lowestLevel } from "./imagery";

/** The page's own coastline, and the deepest levels of it and of the graticule: tiles of 300 and of 150 m. */
const COASTLINE = "/map/canary-coastline.json";
const CHART_LEVELS = 16;
const GRATICULE_LEVELS = 17;
const WORLD = { west_deg: -180, south_deg: -90, east_deg: 180, north_deg: 90 };

/** The lowest layer, which covers the whole Earth. */
export type BaseKind = "natural" | "none";

export type { ImagerySource } from "./imagery";

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

/**
 * The globe's layers, from the lowest: the Earth's image, the chart of the Canary Islands, other layers in the order
 * in which they were added, the graticule.
 */
export class Ground {
  readonly #globe: Globe;
  readonly #natural: ImageryLayer;
  #chart: ImageryLayer | null = null;
  #isCharted = true;
  #graticule: ImageryLayer | null = null;
  #terrain = 0;

  constructor(globe: Globe) {
    this.#globe = globe;
    this.#natural = ImageryLayer.fromProviderAsync(
      TileMapServiceImageryProvider.fromUrl(buildModuleUrl("Assets/Textures/NaturalEarthII")),
    );
    globe.scene.imageryLayers.add(this.#natural);
    void this.#loadChart();
  }

  /** The chart of the Canary Islands. */
  setChart(isVisible: boolean): void {
    this.#isCharted = isVisible;
    if (this.#chart !== null) {
      this.#chart.show = isVisible;
      this.#globe.requestRender();
    }
  }

  /** The graticule with the page's compass letters; null: none. */
  setGraticule(letters: CompassLetters | null): void {
    const layers = this.#globe.scene.imageryLayers;
    if (this.#graticule !== null) {
      layers.remove(this.#graticule, true);
      this.#graticule = null;
    }
    if (letters !== null) {
      this.#graticule = new ImageryLayer(
        new CanvasTiles(WORLD, GRATICULE_LEVELS, (context, box, level) =>
          drawGraticule(context, box, level, letters),
        ),
      );
      layers.add(this.#graticule);
    }
    this.#globe.requestRender();
  }

  async #loadChart(): Promise<void> {
    const islands = await fetchIslands();
    const provider = new CanvasTiles(CHART, CHART_LEVELS, (context, box) => {
      drawCoast(context, box, islands);
      drawAirfield(context, box, GRAN_CANARIA);
      if (needsFade(box)) {
        fadeBorder(context, box);
      }
    });
    this.#chart = new ImageryLayer(provider, { show: this.#isCharted });
    const { imageryLayers } = this.#globe.scene;
    imageryLayers.add(this.#chart, Math.min(1, imageryLayers.length));
    this.#globe.requestRender();
  }

  setBase(kind: BaseKind): void {
    this.#natural.show = kind === "natural";
    this.#globe.requestRender();
  }

  addImagery(source: ImagerySource): ImageryHandle {
    const { west_deg, south_deg, east_deg, north_deg } = coveredBy(source);
    const provider = new UrlTemplateImageryProvider({
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

async function fetchIslands(): Promise<readonly Island[]> {
  const answer = await fetch(COASTLINE);
  if (!answer.ok) {
    throw new Error(`${COASTLINE}: ${answer.status}`);
  }
  return readIslands(await answer.text());
}
