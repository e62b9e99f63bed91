import { type CesiumWidget, type Scene, SkyAtmosphere } from "@cesium/engine";

/** Resolution on slow graphics, relative to the page's, per side: half the work. */
const DEAR_SCALE = 0.7;
/** Allowed error of the ground's tiles on slow graphics, in pixels. */
const DEAR_ERROR_PX = 3;
const CHEAP_ERROR_PX = 1.6;
const CHEAP_SAMPLES = 4;

/** The engine prepares tiles of the ground for five milliseconds per picture: with few pictures that takes minutes. */
const TILES_SHARE = 0.06;
const LEAST_TILES_MS = 10;
const MOST_TILES_MS = 30;

/**
 * Without a graphics processor: the longer a picture takes, the longer tiles are prepared in each. Throws if another
 * version of the engine lacks this setting.
 */
export function hastenTiles({ globe }: Scene, picture_ms: number): void {
  // Not in the published types, which have no equivalent.
  const { _surface: surface } = globe as unknown as { _surface: { _loadQueueTimeSlice: number } };
  if (typeof surface._loadQueueTimeSlice !== "number") {
    throw new Error("the engine's ground has no time for its tiles");
  }
  surface._loadQueueTimeSlice = Math.max(LEAST_TILES_MS, Math.min(MOST_TILES_MS, TILES_SHARE * picture_ms));
}

/** Set the device pixels per CSS pixel and side, without a graphics processor; the ground's tiles stay the same. */
export function setScale(widget: CesiumWidget, scale: number): void {
  widget.resolutionScale = scale;
  widget.scene.globe.maximumScreenSpaceError = (DEAR_ERROR_PX / DEAR_SCALE) * scale;
}

/** On slow graphics, no decoration: sky, ground shading and haze cost most, in this order. */
export function setQuality(widget: CesiumWidget, isDear: boolean): void {
  const { scene } = widget;
  widget.resolutionScale = isDear ? DEAR_SCALE : 1;
  widget.useBrowserRecommendedResolution = isDear;
  scene.msaaSamples = isDear ? 1 : CHEAP_SAMPLES;
  scene.fog.enabled = !isDear;
  scene.globe.showGroundAtmosphere = !isDear;
  scene.globe.enableLighting = false;
  scene.globe.showWaterEffect = false;
  scene.globe.maximumScreenSpaceError = isDear ? DEAR_ERROR_PX : CHEAP_ERROR_PX;
  if (!isDear) {
    scene.skyAtmosphere ??= new SkyAtmosphere();
  }
  // Its type says that it always exists.
  const sky = scene.skyAtmosphere as SkyAtmosphere | undefined;
  if (sky !== undefined) {
    sky.show = !isDear;
  }
}
