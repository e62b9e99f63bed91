import {
  Camera,
  Cartesian2,
  Cartesian3,
  Math as CesiumMath,
  GeographicProjection,
  HeadingPitchRange,
  Matrix4,
  type Scene,
  SceneMode,
} from "@cesium/engine";
import { describe, expect, test } from "vitest";
import type { Waypoint } from "../../lib/plan";
import type { Point, Spot } from "../legs/geometry";
import { WaypointDrag } from "./WaypointDrag";

const WAYPOINT: Waypoint = { latitude_deg: 27.93, longitude_deg: -15.387, altitude_ft: 1000, speed_kt: 55 };
const MIDDLE: Spot = { x: 400, y: 300 };

function placeOf({ latitude_deg, longitude_deg, altitude_ft }: Point): Cartesian3 {
  return Cartesian3.fromDegrees(longitude_deg, latitude_deg, altitude_ft * 0.3048);
}

/** A picture with the waypoint in its middle, seen from the south, 2 km away and so far above it. */
function seen(above_deg: number, width = 800) {
  const scene = {
    mode: SceneMode.SCENE3D,
    mapProjection: new GeographicProjection(),
    ellipsoid: new GeographicProjection().ellipsoid,
    drawingBufferWidth: 800,
    drawingBufferHeight: 600,
    canvas: { clientWidth: width, clientHeight: 600 },
    tweens: undefined,
  } as unknown as Scene;
  const camera = new Camera(scene);
  camera.lookAt(placeOf(WAYPOINT), new HeadingPitchRange(0, CesiumMath.toRadians(-above_deg), 2000));
  camera.lookAtTransform(Matrix4.IDENTITY);
  const withCamera = Object.assign(scene, { camera });
  /** Metres between a point and the line of sight through a spot. */
  const beside_m = (point: Point, { x, y }: Spot): number => {
    const ray = camera.getPickRay(new Cartesian2(x, y));
    if (ray === undefined) {
      throw new Error("no line of sight");
    }
    const away = Cartesian3.subtract(placeOf(point), ray.origin, new Cartesian3());
    return Cartesian3.magnitude(Cartesian3.cross(away, ray.direction, new Cartesian3()));
  };
  return { scene: withCamera, beside_m };
}

describe("a waypoint that is pulled across the map", () => {
  test("stays under the pointer at its height", () => {
    const { scene, beside_m } = seen(30);
    const drag = new WaypointDrag(scene, WAYPOINT, MIDDLE, "level");
    for (const to of [
      { x: 500, y: 300 },
      { x: 380, y: 420 },
      { x: 430, y: 260 },
    ]) {
      const at = drag.move(to, "level");
      expect(at.altitude_ft).toBe(1000);
      expect(beside_m(at, to)).toBeLessThan(0.2);
    }
  });

  test("goes east with a pull to the right and north with one upwards, seen from the south", () => {
    const { scene } = seen(30);
    const drag = new WaypointDrag(scene, WAYPOINT, MIDDLE, "level");
    const right = drag.move({ x: 450, y: 300 }, "level");
    expect(right.longitude_deg).toBeGreaterThan(WAYPOINT.longitude_deg + 1e-4);
    expect(right.latitude_deg).toBeCloseTo(WAYPOINT.latitude_deg, 6);
    const up = drag.move({ x: 400, y: 250 }, "level");
    expect(up.latitude_deg).toBeGreaterThan(WAYPOINT.latitude_deg + 1e-4);
    expect(up.longitude_deg).toBeCloseTo(WAYPOINT.longitude_deg, 6);
  });

  test("does not jump when it was taken hold of beside its middle", () => {
    const { scene } = seen(30);
    const from = { x: 412, y: 307 };
    const at = new WaypointDrag(scene, WAYPOINT, from, "level").move(from, "level");
    expect(at.latitude_deg).toBeCloseTo(WAYPOINT.latitude_deg, 9);
    expect(at.longitude_deg).toBeCloseTo(WAYPOINT.longitude_deg, 9);
  });

  test("stays where it last was while the pointer is in the sky", () => {
    const { scene } = seen(5);
    const drag = new WaypointDrag(scene, WAYPOINT, MIDDLE, "level");
    const last = drag.move({ x: 450, y: 310 }, "level");
    expect(last.longitude_deg).not.toBe(WAYPOINT.longitude_deg);
    expect(drag.move({ x: 450, y: 5 }, "level")).toEqual(last);
  });

  test("never moves if it was taken hold of against the sky", () => {
    const { scene } = seen(5);
    const drag = new WaypointDrag(scene, WAYPOINT, { x: 400, y: 5 }, "level");
    expect(drag.move({ x: 500, y: 400 }, "level")).toEqual(WAYPOINT);
  });
});

describe("a waypoint that is pulled upwards", () => {
  test("stays under the pointer above its place", () => {
    const { scene, beside_m } = seen(30);
    const drag = new WaypointDrag(scene, WAYPOINT, MIDDLE, "upright");
    for (const y of [200, 250, 340]) {
      const at = drag.move({ x: 400, y }, "upright");
      expect(at).toMatchObject({
        latitude_deg: WAYPOINT.latitude_deg,
        longitude_deg: WAYPOINT.longitude_deg,
      });
      expect(at.altitude_ft > 1000).toBe(y < 300);
      expect(beside_m(at, { x: 400, y })).toBeLessThan(0.2);
    }
  });

  test("keeps its height when the pointer goes to the side only", () => {
    const { scene } = seen(0);
    const drag = new WaypointDrag(scene, WAYPOINT, MIDDLE, "upright");
    expect(drag.move({ x: 500, y: 300 }, "upright").altitude_ft).toBeCloseTo(1000, 0);
  });

  test("keeps its height when it is looked at from straight above", () => {
    const { scene } = seen(90);
    const drag = new WaypointDrag(scene, WAYPOINT, MIDDLE, "upright");
    expect(drag.move({ x: 400, y: 200 }, "upright").altitude_ft).toBe(1000);
  });
});

test("a change of direction in the middle of a pull begins where the waypoint is by then", () => {
  const { scene } = seen(30);
  const drag = new WaypointDrag(scene, WAYPOINT, MIDDLE, "level");
  const to = { x: 470, y: 330 };
  const level = drag.move(to, "level");
  const turned = drag.move(to, "upright");
  expect(turned.altitude_ft).toBeCloseTo(1000, 6);
  const higher = drag.move({ x: 470, y: 280 }, "upright");
  expect(higher.altitude_ft).toBeGreaterThan(1050);
  expect(higher.latitude_deg).toBe(level.latitude_deg);
  expect(higher.longitude_deg).toBe(level.longitude_deg);
  const back = drag.move({ x: 470, y: 280 }, "level");
  expect(back.altitude_ft).toBe(higher.altitude_ft);
  expect(back.longitude_deg).toBeCloseTo(level.longitude_deg, 9);
});

test("a picture without a size moves no waypoint", () => {
  const { scene } = seen(30, 0);
  for (const way of ["level", "upright"] as const) {
    const drag = new WaypointDrag(scene, WAYPOINT, MIDDLE, way);
    expect(drag.move({ x: 500, y: 200 }, way)).toEqual(WAYPOINT);
  }
});
