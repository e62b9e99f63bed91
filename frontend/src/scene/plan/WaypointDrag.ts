import {
  Cartesian2,
  Cartesian3,
  Cartographic,
  Math as CesiumMath,
  Matrix4,
  type Ray,
  type Scene,
  Transforms,
} from "@cesium/engine";
import type { Waypoint } from "../../lib/plan";
import { METRES_PER_FOOT } from "../../lib/units";
import {
  type Enu,
  heightAlongVertical,
  type Point,
  type Sight,
  type Spot,
  throughLevel,
} from "../legs/geometry";

/** Horizontally at its height, or vertically at its position. */
export type DragWay = "level" | "upright";

/** A waypoint that is being dragged: its position for each position of the pointer. */
export class WaypointDrag {
  readonly #scene: Scene;
  #way: DragWay;
  #anchor: Anchor;
  #at: Point;

  constructor(scene: Scene, waypoint: Waypoint, from: Spot, way: DragWay) {
    this.#scene = scene;
    this.#way = way;
    this.#at = waypoint;
    this.#anchor = new Anchor(scene, waypoint, from);
  }

  /** The waypoint's position now. A change of direction starts at the pointer's present position. */
  move(to: Spot, way: DragWay): Point {
    if (way !== this.#way) {
      this.#way = way;
      this.#anchor = new Anchor(this.#scene, this.#at, to);
    }
    this.#at = (way === "level" ? this.#anchor.along(to) : this.#anchor.upwards(to)) ?? this.#at;
    return this.#at;
  }
}

/** The horizontal plane and the vertical of a waypoint when it was grabbed. */
class Anchor {
  readonly #scene: Scene;
  readonly #point: Point;
  readonly #toFixed: Matrix4;
  readonly #toLocal: Matrix4;
  /** Offset of the grabbed spot from the waypoint. */
  readonly #beside: Enu | null;
  readonly #held_m: number | null;

  constructor(scene: Scene, point: Point, from: Spot) {
    this.#scene = scene;
    this.#point = point;
    this.#toFixed = Transforms.eastNorthUpToFixedFrame(
      Cartesian3.fromDegrees(point.longitude_deg, point.latitude_deg),
    );
    this.#toLocal = Matrix4.inverseTransformation(this.#toFixed, new Matrix4());
    const sight = this.#sight(from);
    this.#beside = sight === null ? null : throughLevel(sight, this.#up_m);
    this.#held_m = sight === null ? null : heightAlongVertical(sight);
  }

  along(to: Spot): Point | null {
    const sight = this.#sight(to);
    const reached = sight === null ? null : throughLevel(sight, this.#up_m);
    if (reached === null || this.#beside === null) {
      return null;
    }
    const local = new Cartesian3(
      reached.east_m - this.#beside.east_m,
      reached.north_m - this.#beside.north_m,
      this.#up_m,
    );
    const place = Cartographic.fromCartesian(Matrix4.multiplyByPoint(this.#toFixed, local, local));
    return {
      latitude_deg: CesiumMath.toDegrees(place.latitude),
      longitude_deg: CesiumMath.toDegrees(place.longitude),
      altitude_ft: this.#point.altitude_ft,
    };
  }

  upwards(to: Spot): Point | null {
    const sight = this.#sight(to);
    const reached_m = sight === null ? null : heightAlongVertical(sight);
    return reached_m === null || this.#held_m === null
      ? null
      : {
          ...this.#point,
          altitude_ft: this.#point.altitude_ft + (reached_m - this.#held_m) / METRES_PER_FOOT,
        };
  }

  get #up_m(): number {
    return this.#point.altitude_ft * METRES_PER_FOOT;
  }

  #sight({ x, y }: Spot): Sight | null {
    const ray: Ray | undefined = this.#scene.camera.getPickRay(new Cartesian2(x, y));
    if (ray === undefined) {
      return null;
    }
    return {
      origin: enu(Matrix4.multiplyByPoint(this.#toLocal, ray.origin, new Cartesian3())),
      direction: enu(Matrix4.multiplyByPointAsVector(this.#toLocal, ray.direction, new Cartesian3())),
    };
  }
}

function enu({ x, y, z }: Cartesian3): Enu {
  return { east_m: x, north_m: y, up_m: z };
}
