import {
  Camera,
  Cartesian3,
  Math as CesiumMath,
  GeographicProjection,
  HeadingPitchRange,
  Matrix4,
  type Scene,
  SceneMode,
} from "@cesium/engine";
import { expect, test } from "vitest";
import { Projector } from "./Projector";

const GANDO = Cartesian3.fromDegrees(-15.387, 27.93);

/** A picture of 800 by 600 pixels with Gando in its middle, seen from the south and from 30 degrees above. */
function projector(away_m = 10_000): Projector {
  const geographic = new GeographicProjection();
  const camera = new Camera({
    mode: SceneMode.SCENE3D,
    mapProjection: geographic,
    ellipsoid: geographic.ellipsoid,
    drawingBufferWidth: 800,
    drawingBufferHeight: 600,
    canvas: { clientWidth: 800, clientHeight: 600 },
    tweens: undefined,
  } as unknown as Scene);
  camera.lookAt(GANDO, new HeadingPitchRange(0, CesiumMath.toRadians(-30), away_m));
  camera.lookAtTransform(Matrix4.IDENTITY);
  const made = new Projector();
  made.set(camera, 800, 600);
  return made;
}

test("what the camera looks at is in the middle of the picture, at its distance", () => {
  const spot = projector().ground(GANDO);
  expect(spot?.x).toBeCloseTo(400, 3);
  expect(spot?.y).toBeCloseTo(300, 3);
  expect(projector().distance_m(GANDO)).toBeCloseTo(10_000, 3);
});

test("east is on the right and what lies higher or farther to the north is above, seen from the south", () => {
  const east = projector().ground(Cartesian3.fromDegrees(-15.377, 27.93));
  expect(east?.x).toBeGreaterThan(420);
  expect(east?.y).toBeCloseTo(300, 0);
  expect(projector().ground(Cartesian3.fromDegrees(-15.387, 27.94))?.y).toBeLessThan(290);
  expect(projector().ground(Cartesian3.fromDegrees(-15.387, 27.93, 1000))?.y).toBeLessThan(260);
});

test("what is behind the camera has no spot", () => {
  const behind = Cartesian3.fromDegrees(-15.387, 27.5);
  expect(projector().spot(behind)).toBeNull();
  expect(projector().ground(behind)).toBeNull();
});

test("ground on the far side of the Earth is hidden by it, though it lies ahead", () => {
  const far = Cartesian3.fromDegrees(-15.387 + 180, 20);
  const seen = projector(20_000_000);
  expect(seen.spot(far)).not.toBeNull();
  expect(seen.ground(far)).toBeNull();
});
