import type { CesiumWidget, Scene } from "@cesium/engine";
import { describe, expect, test } from "vitest";
import { hastenTiles, setQuality, setScale } from "./quality";

/** As much of the engine's picture as its quality is about; `sky`: what it has of one. */
function aWidget(sky?: { show: boolean }) {
  return {
    resolutionScale: 0,
    useBrowserRecommendedResolution: false,
    scene: {
      msaaSamples: 0,
      fog: { enabled: true },
      skyAtmosphere: sky,
      globe: {
        showGroundAtmosphere: true,
        enableLighting: true,
        showWaterEffect: true,
        maximumScreenSpaceError: 2,
      },
    },
  };
}

describe("slow graphics", () => {
  test("draw fewer pixels and coarser ground, and nothing that only decorates", () => {
    const sky = { show: true };
    const widget = aWidget(sky);
    setQuality(widget as unknown as CesiumWidget, true);
    expect(widget.resolutionScale).toBeLessThan(1);
    expect(widget.useBrowserRecommendedResolution).toBe(true);
    expect(widget.scene.msaaSamples).toBe(1);
    expect(widget.scene.fog.enabled).toBe(false);
    expect(widget.scene.globe).toEqual({
      showGroundAtmosphere: false,
      enableLighting: false,
      showWaterEffect: false,
      maximumScreenSpaceError: 3,
    });
    expect(sky.show).toBe(false);
  });

  test("get no sky only to hide it", () => {
    const widget = aWidget();
    setQuality(widget as unknown as CesiumWidget, true);
    expect(widget.scene.skyAtmosphere).toBeUndefined();
  });
});

test("fast graphics show the sky again after slow ones, at full resolution", () => {
  const sky = { show: true };
  const widget = aWidget(sky);
  setQuality(widget as unknown as CesiumWidget, true);
  setQuality(widget as unknown as CesiumWidget, false);
  expect(sky.show).toBe(true);
  expect(widget.scene.skyAtmosphere).toBe(sky);
  expect(widget.resolutionScale).toBe(1);
  expect(widget.scene.msaaSamples).toBeGreaterThan(1);
  expect(widget.scene.fog.enabled).toBe(true);
  expect(widget.scene.globe.maximumScreenSpaceError).toBeLessThan(3);
  // The globe always shows the noon of one day: no side of it is dark.
  expect(widget.scene.globe.enableLighting).toBe(false);
});

test("fast graphics get a sky where there was none", () => {
  const widget = aWidget();
  setQuality(widget as unknown as CesiumWidget, false);
  expect(widget.scene.skyAtmosphere?.show).toBe(true);
});

test("the same tiles of the ground are shown at every scale of the picture", () => {
  const widget = aWidget();
  const perPixel = [1, 0.7, 0.35].map((scale) => {
    setScale(widget as unknown as CesiumWidget, scale);
    expect(widget.resolutionScale).toBe(scale);
    return widget.scene.globe.maximumScreenSpaceError / scale;
  });
  expect(perPixel[1]).toBeCloseTo(perPixel[0] ?? 0, 9);
  expect(perPixel[2]).toBeCloseTo(perPixel[0] ?? 0, 9);
});

describe("the time for tiles in each picture", () => {
  test.each([
    ["grows with the picture's own", 300, 18],
    ["is never so short that the ground takes minutes", 16, 10],
    ["is never so long that the picture stands still", 5000, 30],
  ])("%s", (_, picture_ms, wanted_ms) => {
    const surface = { _loadQueueTimeSlice: 5 };
    hastenTiles({ globe: { _surface: surface } } as unknown as Scene, picture_ms);
    expect(surface._loadQueueTimeSlice).toBeCloseTo(wanted_ms, 9);
  });

  test("that an engine does not have is told, not passed over", () => {
    const scene = { globe: { _surface: {} } } as unknown as Scene;
    expect(() => hastenTiles(scene, 100)).toThrow(/no time for its tiles/);
  });
});
