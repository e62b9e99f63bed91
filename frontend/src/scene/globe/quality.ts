import { type CesiumWidget, type Scene, SkyAtmosphere } from "@cesium/engine";

/** Of the page's points, to each side, where each of them is dear; half the work of all of them. */
const DEAR_SCALE = 0.7;
/** How coarse the ground's tiles may be, in pixels. */
const DEAR_ERROR_PX = 3;
const CHEAP_ERROR_PX = 1.6;
const CHEAP_SAMPLES = 4;

/** In each frame the engine makes tiles of the ground ready for five milliseconds: minutes, where frames are few. */
const TILES_SHARE = 0.06;
const LEAST_TILES_MS = 10;
const MOST_TILES_MS = 30;

/**
 * Ground that the processor draws alone: the longer a frame takes, the longer its tiles are worked on in each. Throws
 * where another version of the engine has no such time.
 */
export function hastenTiles({ globe }: Scene, frame_ms: number): void {
  // Not in its published types, and nothing that is says as much.
  const { _surface: surface } = globe as unknown as { _surface: { _loadQueueTimeSlice: number } };
  if (typeof surface._loadQueueTimeSlice !== "number") {
    throw new Error("the engine's ground has no time for its tiles");
  }
  surface._loadQueueTimeSlice = Math.max(LEAST_TILES_MS, Math.min(MOST_TILES_MS, TILES_SHARE * frame_ms));
}

/** A picture that the processor draws alone, in so many points to each side of a CSS pixel: the ground's tiles stay the same. */
export function setScale(widget: CesiumWidget, scale: number): void {
  widget.resolutionScale = scale;
  widget.scene.globe.maximumScreenSpaceError = (DEAR_ERROR_PX / DEAR_SCALE) * scale;
}

/** Where a frame is dear nothing is drawn that is only beautiful: in this order sky, ground shading, haze cost most. */
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
  // Typed as always there.
  const sky = scene.skyAtmosphere as SkyAtmosphere | undefined;
  if (sky !== undefined) {
    sky.show = !isDear;
  }
}
