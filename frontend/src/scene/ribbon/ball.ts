import { BoundingSphere, Cartesian3, type CullingVolume } from "@cesium/engine";
import type { Bounds } from "./vertices";

/**
 * The local vertical is not exactly the line to the earth's centre: the ground point below is off by this share of
 * the height.
 */
const ASLANT = 0.005;

/** A sphere around this sphere in the air and everything below it down to the sea; written to `into` if given. */
export function downToTheSea(
  { centre: [x, y, z], radius_m, top_m }: Bounds,
  into = new BoundingSphere(),
): BoundingSphere {
  const height_m = Math.max(0, top_m);
  const share = 1 - height_m / 2 / Math.max(1, Math.hypot(x, y, z));
  Cartesian3.fromElements(x * share, y * share, z * share, into.center);
  into.radius = radius_m + height_m * (0.5 + ASLANT);
  return into;
}

/**
 * Whether a camera sees any part of a sphere. The engine's own test allocates a plane per call, and hundreds of
 * spheres are tested for each picture.
 */
export function isWithin(
  { center: { x, y, z }, radius }: BoundingSphere,
  { planes }: CullingVolume,
): boolean {
  for (const plane of planes) {
    if (plane.x * x + plane.y * y + plane.z * z + plane.w < -radius) {
      return false;
    }
  }
  return true;
}
