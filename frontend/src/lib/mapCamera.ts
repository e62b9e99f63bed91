/** Camera modes of the globe: following an aircraft, free, or in an aircraft's cockpit. */
export const CAMERAS = ["follow", "free", "cockpit"] as const;
export type CameraMode = (typeof CAMERAS)[number];

/** The setting that stores the chosen mode. */
export const CAMERA_CHOICE = "map.camera";

/** The stored mode; by default `follow`. */
export function cameraOf(choice: string | undefined): CameraMode {
  return CAMERAS.find((mode) => mode === choice) ?? "follow";
}

/** The next mode, in a cycle. */
export function nextCamera(mode: CameraMode): CameraMode {
  return CAMERAS[(CAMERAS.indexOf(mode) + 1) % CAMERAS.length] ?? mode;
}
