import {
  CesiumTerrainProvider,
  Color,
  EllipsoidTerrainProvider,
  type ImageryLayer,
  ImageryLayerCollection,
  TileMapServiceImageryProvider,
  UrlTemplateImageryProvider,
} from "@cesium/engine";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { GROUND } from "../look";
import { CanvasTiles } from "./chart/CanvasTiles";
import { WorldTiles } from "./chart/WorldTiles";
import type { Globe } from "./Globe";
import { Ground, type ImagerySource } from "./ground";

const CANARIES: ImagerySource = {
  url: "/tiles/{z}/{x}/{y}",
  west_deg: -18,
  south_deg: 27,
  east_deg: -13,
  north_deg: 29,
  minimum_zoom: 6,
  maximum_zoom: 15,
};

/** As much of a globe as its ground asks for. */
function bareGlobe() {
  const imageryLayers = new ImageryLayerCollection();
  const bare = { baseColor: Color.BLUE };
  const scene = { imageryLayers, requestRender: vi.fn(), terrainProvider: null as unknown, globe: bare };
  const requestRender = vi.fn();
  const ground = new Ground({ scene, requestRender } as unknown as Globe);
  /** From the lowest. */
  const layers = (): ImageryLayer[] =>
    Array.from({ length: imageryLayers.length }, (_, index) => imageryLayers.get(index));
  const kinds = (): string[] =>
    layers().map((layer) => {
      const provider = layer.imageryProvider as unknown;
      if (provider instanceof WorldTiles) {
        return "chart";
      }
      if (provider instanceof CanvasTiles) {
        return "graticule";
      }
      return provider instanceof UrlTemplateImageryProvider ? provider.url : "natural";
    });
  return { ground, scene, requestRender, layers, kinds };
}

beforeEach(() => {
  // The Earth's picture is a file of the page; nothing here looks at it.
  vi.spyOn(TileMapServiceImageryProvider, "fromUrl").mockReturnValue(new Promise(() => undefined));
});

describe("the globe's layers", () => {
  test("lie over each other as they were added, and the graticule over all", () => {
    const { ground, kinds } = bareGlobe();
    expect(kinds()).toEqual(["natural", "chart"]);
    ground.setGraticule(true);
    ground.addImagery({ ...CANARIES, url: "/one" });
    ground.addImagery({ ...CANARIES, url: "/two" });
    expect(kinds()).toEqual(["natural", "chart", "/one", "/two", "graticule"]);
  });

  test("have one graticule, or none", () => {
    const { ground, kinds, requestRender } = bareGlobe();
    ground.setGraticule(true);
    ground.setGraticule(true);
    expect(kinds()).toEqual(["natural", "chart", "graticule"]);
    ground.setGraticule(false);
    expect(kinds()).toEqual(["natural", "chart"]);
    ground.addImagery({ ...CANARIES, url: "/one" });
    ground.setGraticule(true);
    expect(kinds()).toEqual(["natural", "chart", "/one", "graticule"]);
    expect(requestRender.mock.calls.length).toBeGreaterThanOrEqual(5);
  });
});

describe("the chart", () => {
  test("of the night takes the place of the day's under all other layers, without the Earth's picture", () => {
    const { ground, kinds, layers, scene } = bareGlobe();
    const bare = () => scene.globe.baseColor.toCssHexString();
    expect(bare()).toBe(GROUND.day.sea);
    ground.addImagery({ ...CANARIES, url: "/one" });
    const [natural, day] = layers();
    ground.setLight("night");
    expect(bare()).toBe(GROUND.night.sea);
    expect(kinds()).toEqual(["natural", "chart", "/one"]);
    expect(layers()[1]).not.toBe(day);
    expect(natural?.show).toBe(false);
    ground.setLight("day");
    expect(natural?.show).toBe(true);
  });

  test("is not drawn anew for the light that it has", () => {
    const { ground, layers, requestRender } = bareGlobe();
    const before = layers();
    ground.setLight("day");
    expect(layers()).toEqual(before);
    expect(requestRender).not.toHaveBeenCalled();
  });
});

describe("a layer of pictures", () => {
  test("asks for tiles only where it has some and as deep as it has them", () => {
    const { ground, layers } = bareGlobe();
    ground.addImagery(CANARIES);
    const provider = layers().at(-1)?.imageryProvider;
    expect(provider?.minimumLevel).toBe(6);
    expect(provider?.maximumLevel).toBe(15);
    const { west, south, east, north } = provider?.rectangle ?? {};
    const degrees = [west, south, east, north].map((angle) => ((angle ?? 0) * 180) / Math.PI);
    [-18, 27, -13, 29].forEach((wanted, index) => {
      expect(degrees[index]).toBeCloseTo(wanted, 9);
    });
  });

  test("is hidden, faded and taken away, and each is shown at once", () => {
    const { ground, layers, kinds, requestRender } = bareGlobe();
    const handle = ground.addImagery(CANARIES);
    const layer = layers().at(-1);
    requestRender.mockClear();
    handle.setVisible(false);
    expect(layer?.show).toBe(false);
    handle.setVisible(true);
    expect(layer?.show).toBe(true);
    handle.setOpacity(0.3);
    expect(layer?.alpha).toBe(0.3);
    handle.remove();
    expect(kinds()).toEqual(["natural", "chart"]);
    expect(requestRender).toHaveBeenCalledTimes(4);
  });
});

describe("the terrain", () => {
  test("is at sea level everywhere without a source", async () => {
    const { ground, scene, requestRender } = bareGlobe();
    await ground.setTerrain(null);
    expect(scene.terrainProvider).toBeInstanceOf(EllipsoidTerrainProvider);
    expect(requestRender).toHaveBeenCalledOnce();
  });

  test("that was chosen last is shown, though an earlier one is read later", async () => {
    const { ground, scene } = bareGlobe();
    let readSlow: (provider: CesiumTerrainProvider) => void = () => undefined;
    const slow = new Promise<CesiumTerrainProvider>((resolve) => {
      readSlow = resolve;
    });
    const [first, second] = [{}, {}] as [CesiumTerrainProvider, CesiumTerrainProvider];
    vi.spyOn(CesiumTerrainProvider, "fromUrl").mockImplementation((url) =>
      url === "/slow" ? slow : Promise.resolve(second),
    );
    const waiting = ground.setTerrain({ url: "/slow" });
    await ground.setTerrain({ url: "/quick" });
    readSlow(first);
    await waiting;
    expect(scene.terrainProvider).toBe(second);
  });

  test("that cannot be read is refused, and the old one stays", async () => {
    const { ground, scene } = bareGlobe();
    await ground.setTerrain(null);
    const before = scene.terrainProvider;
    vi.spyOn(CesiumTerrainProvider, "fromUrl").mockRejectedValue(new Error("cut off"));
    await expect(ground.setTerrain({ url: "/bad" })).rejects.toThrow("cut off");
    expect(scene.terrainProvider).toBe(before);
  });
});
