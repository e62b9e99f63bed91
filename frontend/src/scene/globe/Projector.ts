import { type Camera, Cartesian3, Cartesian4, Matrix4 } from "@cesium/engine";
import type { Spot } from "../../lib/labels";

/**
 * Greatest depression of the camera below a point's horizon, as a sine, from which things above the point are still
 * visible.
 */
const BELOW_HORIZON = -0.02;

/** Points of space on the picture, for one camera: hundreds of names are looked at for each picture. */
export class Projector {
  readonly #matrix = new Matrix4();
  readonly #place = new Cartesian4();
  readonly #eye = new Cartesian3();
  #width = 0;
  #height = 0;

  /** Use this camera for a picture of this size in CSS pixels. */
  set(camera: Camera, width_px: number, height_px: number): void {
    Matrix4.multiply(camera.frustum.projectionMatrix, camera.viewMatrix, this.#matrix);
    Cartesian3.clone(camera.positionWC, this.#eye);
    [this.#width, this.#height] = [width_px, height_px];
  }

  /** Metres from the camera. */
  distance_m(point: Cartesian3): number {
    return Cartesian3.distance(this.#eye, point);
  }

  /** A point on or over the ground; null behind the camera or the Earth. */
  ground(point: Cartesian3): Spot | null {
    const { x, y, z } = point;
    const eye = this.#eye;
    const [dx, dy, dz] = [eye.x - x, eye.y - y, eye.z - z];
    const up = (dx * x + dy * y + dz * z) / (Math.hypot(dx, dy, dz) * Math.hypot(x, y, z));
    return up < BELOW_HORIZON ? null : this.spot(point);
  }

  /** Any point in front of the camera; null behind it. */
  spot({ x, y, z }: Cartesian3): Spot | null {
    const place = Cartesian4.fromElements(x, y, z, 1, this.#place);
    const seen = Matrix4.multiplyByVector(this.#matrix, place, place);
    return seen.w > 0
      ? { x: ((seen.x / seen.w + 1) / 2) * this.#width, y: ((1 - seen.y / seen.w) / 2) * this.#height }
      : null;
  }
}
