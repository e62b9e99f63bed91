import { BoundingSphere, Cartesian3, Intersect, PerspectiveFrustum } from "@cesium/engine";
import { expect, test } from "vitest";
import { downToTheSea, isWithin } from "./ball";
import { boundsOf, POINT_FLOATS, writePlace } from "./vertices";

const PLACES = [
  { latitude_deg: 27.93, longitude_deg: -15.38, altitude_m: 2800 },
  { latitude_deg: 27.96, longitude_deg: -15.41, altitude_m: 350 },
  { latitude_deg: 27.9, longitude_deg: -15.36, altitude_m: 1200 },
];

test("a line's ball holds each of its points and the sea below it, and little more", () => {
  const vertices = new Float32Array(PLACES.length * POINT_FLOATS);
  for (const [at, place] of PLACES.entries()) {
    writePlace(vertices, at, place);
  }
  const ball = downToTheSea(boundsOf(vertices, PLACES.length));
  for (const { latitude_deg, longitude_deg, altitude_m } of PLACES) {
    for (const height_m of [altitude_m, altitude_m / 2, 0]) {
      const at = Cartesian3.fromDegrees(longitude_deg, latitude_deg, height_m);
      expect(Cartesian3.distance(at, ball.center)).toBeLessThan(ball.radius);
    }
  }
  expect(ball.radius).toBeLessThan(8000);
});

test("what flies below the sea's level has a ball of its own size", () => {
  const ball = downToTheSea({ centre: [6_378_000, 0, 0], radius_m: 50, top_m: -20 });
  expect(ball.radius).toBe(50);
  expect(ball.center.x).toBe(6_378_000);
});

test("a ball is within what the camera sees where the engine says so", () => {
  const frustum = new PerspectiveFrustum({ fov: 1, aspectRatio: 1.5, near: 1, far: 1e6 });
  const volume = frustum.computeCullingVolume(Cartesian3.ZERO, Cartesian3.UNIT_X, Cartesian3.UNIT_Z);
  const answers = new Set<boolean>();
  for (let step = 0; step < 400; step += 1) {
    const at = new Cartesian3(300 * Math.sin(step), 300 * Math.sin(2.3 * step), 300 * Math.cos(1.7 * step));
    const ball = new BoundingSphere(at, 10 + (step % 60));
    const isSeen = isWithin(ball, volume);
    expect(isSeen, `${step}`).toBe(volume.computeVisibility(ball) !== Intersect.OUTSIDE);
    answers.add(isSeen);
  }
  expect(answers.size).toBe(2);
});
