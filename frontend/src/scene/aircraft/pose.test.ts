import {
  Camera,
  Cartesian3,
  GeographicProjection,
  HeadingPitchRoll,
  Matrix4,
  type Scene,
  SceneMode,
  Transforms,
} from "@cesium/engine";
import { describe, expect, test } from "vitest";
import type { FullAttitude, Vector } from "../../lib/attitude";
import { modelMatrix, type Place, poseOf } from "./pose";

const GANDO: Place = { latitude_deg: 27.93, longitude_deg: -15.387, altitude_m: 305 };
const FAR_SOUTH: Place = { latitude_deg: -51.8, longitude_deg: 171.2, altitude_m: 12 };

/** Thirty attitudes: every quadrant of heading, climbs and dives, both banks, on its back, near the vertical. */
const ATTITUDES: FullAttitude[] = Array.from({ length: 30 }, (_, index) => ({
  yaw_deg: (index * 47) % 360,
  pitch_deg: [0, 12, -18, 45, -60, 84][index % 6] ?? 0,
  roll_deg: [0, 25, -40, 90, -135][index % 5] ?? 0,
}));

/** The textbook's rotation, written out: rows north, east, down; columns ahead, right, down of the airframe. */
function textbook({ yaw_deg, pitch_deg, roll_deg }: FullAttitude): readonly [Vector, Vector, Vector] {
  const [sy, cy] = [Math.sin((yaw_deg * Math.PI) / 180), Math.cos((yaw_deg * Math.PI) / 180)];
  const [sp, cp] = [Math.sin((pitch_deg * Math.PI) / 180), Math.cos((pitch_deg * Math.PI) / 180)];
  const [sr, cr] = [Math.sin((roll_deg * Math.PI) / 180), Math.cos((roll_deg * Math.PI) / 180)];
  return [
    [cp * cy, sr * sp * cy - cr * sy, cr * sp * cy + sr * sy],
    [cp * sy, sr * sp * sy + cr * cy, cr * sp * sy - sr * cy],
    [-sp, sr * cp, cr * cp],
  ];
}

/** A vector of the airframe in north, east, up, by way of the engine's own axes at the place. */
function inEngine(place: Place, vector: Vector): Vector {
  const axes = Transforms.eastNorthUpToFixedFrame(
    Cartesian3.fromDegrees(place.longitude_deg, place.latitude_deg, place.altitude_m),
  );
  const local = Matrix4.multiplyByPointAsVector(
    Matrix4.inverse(axes, new Matrix4()),
    new Cartesian3(...vector),
    new Cartesian3(),
  );
  return [local.y, local.x, local.z];
}

function expectVector(found: Vector, wanted: Vector): void {
  wanted.forEach((part, axis) => {
    expect(found[axis]).toBeCloseTo(part, 6);
  });
}

describe.each([
  ["near Gando", GANDO],
  ["in the far south, near the antimeridian", FAR_SOUTH],
])("%s", (_, place) => {
  test.each(ATTITUDES)("nose, right wing and up lie as by trigonometry: %o", (attitude) => {
    const pose = poseOf(place, attitude);
    const [north, east, down] = textbook(attitude);
    expectVector(inEngine(place, pose.ahead), [north[0], east[0], -down[0]]);
    expectVector(inEngine(place, pose.right), [north[1], east[1], -down[1]]);
    expectVector(inEngine(place, pose.up), [-north[2], -east[2], down[2]]);
  });

  test.each(ATTITUDES)(
    "the model lies as the engine's own heading, pitch and roll have it: %o",
    (attitude) => {
      const matrix = modelMatrix(poseOf(place, attitude));
      const { yaw_deg, pitch_deg, roll_deg } = attitude;
      // The engine's heading turns a nose that points east.
      const expected = Transforms.headingPitchRollToFixedFrame(
        Cartesian3.fromDegrees(place.longitude_deg, place.latitude_deg, place.altitude_m),
        HeadingPitchRoll.fromDegrees(yaw_deg - 90, pitch_deg, roll_deg),
      );
      Matrix4.toArray(expected).forEach((part, index) => {
        expect(matrix[index]).toBeCloseTo(part, index >= 12 ? 3 : 6);
      });
    },
  );

  test.each(ATTITUDES)(
    "a camera in the cockpit sees the horizon of the attitude indicator: %o",
    (attitude) => {
      const { position, ahead, up } = poseOf(place, attitude);
      const camera = new Camera(aScene());
      camera.setView({
        destination: new Cartesian3(...position),
        orientation: { direction: new Cartesian3(...ahead), up: new Cartesian3(...up) },
      });
      expect(turns(camera.heading, attitude.yaw_deg)).toBeCloseTo(0, 3);
      expect(turns(camera.pitch, attitude.pitch_deg)).toBeCloseTo(0, 3);
      expect(turns(camera.roll, attitude.roll_deg)).toBeCloseTo(0, 3);
    },
  );
});

/** Degrees between an angle of the engine and one of ours, -180..180. */
function turns(angle_rad: number, angle_deg: number): number {
  return (((((angle_rad * 180) / Math.PI - angle_deg + 180) % 360) + 360) % 360) - 180;
}

/** As much of a scene as a camera asks for. */
function aScene(): Scene {
  return {
    mode: SceneMode.SCENE3D,
    mapProjection: new GeographicProjection(),
    ellipsoid: new GeographicProjection().ellipsoid,
    drawingBufferWidth: 800,
    drawingBufferHeight: 600,
    canvas: { clientWidth: 800, clientHeight: 600 },
    tweens: undefined,
  } as unknown as Scene;
}
