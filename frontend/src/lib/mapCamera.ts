/** How the globe is looked at: after an aircraft, as the person turns it, or out of an aircraft. */
export const CAMERAS = ["follow", "free", "cockpit"] as const;
export type CameraMode = (typeof CAMERAS)[number];

/** The name under which the chosen one is remembered. */
export const CAMERA_CHOICE = "map.camera";

/** The one remembered by that name; without one the camera follows. */
export function cameraOf(choice: string | undefined): CameraMode {
  return CAMERAS.find((mode) => mode === choice) ?? "follow";
}

/** The one behind it, round and round. */
export function nextCamera(mode: CameraMode): CameraMode {
  return CAMERAS[(CAMERAS.indexOf(mode) + 1) % CAMERAS.length] ?? mode;
}
