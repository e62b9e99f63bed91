import { Cartesian2, Cartesian3, type Scene, SceneTransforms } from "@cesium/engine";
import type { Spot } from "../legs/geometry";

/**
 * Greatest depression of the camera below a point's horizon, as a sine, from which things above the point are still
 * visible.
 */
const BELOW_HORIZON = -0.05;

const scratch = { up: new Cartesian3(), sight: new Cartesian3(), spot: new Cartesian2() };

/** A point in space on the canvas; null if it is behind the camera or the Earth. */
export function spotOnScreen(scene: Scene, position: Cartesian3): Spot | null {
  const up = scene.globe.ellipsoid.geodeticSurfaceNormal(position, scratch.up);
  const sight = Cartesian3.subtract(scene.camera.positionWC, position, scratch.sight);
  if (up !== undefined && Cartesian3.dot(up, sight) < BELOW_HORIZON * Cartesian3.magnitude(sight)) {
    return null;
  }
  const spot = SceneTransforms.worldToWindowCoordinates(scene, position, scratch.spot);
  return spot === undefined ? null : { x: spot.x, y: spot.y };
}
