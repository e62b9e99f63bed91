import { type CesiumWidget, type Scene, SkyAtmosphere } from "@cesium/engine";

/** Of the page's points, to each side, where each of them is dear; half the work of all of them. */
const DEAR_SCALE = 0.7;
/** How coarse the ground's tiles may be, in pixels. */
const DEAR_ERROR_PX = 3;
const CHEAP_ERROR_PX = 1.6;
const CHEAP_SAMPLES = 4;

/** In a frame, tiles of the ground are made ready for so long; with its five the engine takes half a minute where frames are few. */
const SOFTWARE_TILES_MS = 10;

/** Ground that the processor draws alone is there twice as soon. Throws where another version of the engine has no such thing. */
export function hastenTiles({ globe }: Scene): void {
  // Not in its published types, and nothing that is says as much.
  const { _surface: surface } = globe as unknown as { _surface: { _loadQueueTimeSlice: number } };
  if (typeof surface._loadQueueTimeSlice !== "number") {
    throw new Error("the engine's ground has no time slice for its tiles");
  }
  surface._loadQueueTimeSlice = SOFTWARE_TILES_MS;
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
