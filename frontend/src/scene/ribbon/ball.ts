import { BoundingSphere, Cartesian3, type CullingVolume } from "@cesium/engine";
import type { Bounds } from "./vertices";

/** The ground under a place lies by so much of its height off the line to the earth's centre, which is not quite upright. */
const ASLANT = 0.005;

/** Round a ball of the air and what is below it, down to the sea; `into`, where given, becomes it. */
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
 * Whether any of a ball is within what a camera sees. The engine's own test makes a plane anew for each of them, and here
 * hundreds of balls are asked about in every frame.
 */
export function isWithin(
  { center: { x, y, z }, radius }: BoundingSphere,
  { planes }: CullingVolume,
): boolean {
  return planes.every((plane) => plane.x * x + plane.y * y + plane.z * z + plane.w >= -radius);
}
