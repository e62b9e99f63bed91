import { beforeEach, describe, expect, test } from "vitest";
import { AttitudeScene } from "../../scene/attitude/AttitudeScene";
import { TelemetryStore } from "../../store/telemetry";
import { AttitudeFeed } from "./feed";

let telemetry: TelemetryStore;
let scene: AttitudeScene;
let feed: AttitudeFeed;
let changes: number;
let pictures: number;
let dataset: DOMStringMap;

beforeEach(() => {
  telemetry = new TelemetryStore();
  telemetry.greet(0, 0);
  scene = new AttitudeScene();
  changes = pictures = 0;
  feed = new AttitudeFeed(scene, () => {
    changes += 1;
  });
  dataset = {};
});

type Angles = readonly [yaw_deg: number | null, pitch_deg: number | null, roll_deg: number | null];

function hear(topic: string, [yaw_deg, pitch_deg, roll_deg]: Angles, now_ms: number): void {
  const sample = { topic, t_s: now_ms / 1000, values: { yaw_deg, pitch_deg, roll_deg } };
  telemetry.apply(now_ms / 1000, [sample], now_ms);
}

/** Feed now, draw half a second later when all motion has ended, and return what was written to the dataset. */
function look(source: "ahrs" | "ahrs_test", now_ms: number): DOMStringMap {
  feed.feed(telemetry, source, null, now_ms);
  scene.advance(now_ms + 500);
  pictures += 1;
  feed.tell(dataset, pictures);
  return dataset;
}

const ATTITUDES: Angles[] = [
  [27, 8, -12],
  [-170, -30, 95],
  [359, 60, -179],
  [91, -75, 44],
];

test.each(ATTITUDES)("the model is turned as the board says: %d %d %d", (yaw_deg, pitch_deg, roll_deg) => {
  hear("ahrs", [yaw_deg, pitch_deg, roll_deg], 100);
  const shown = look("ahrs", 100);
  expect(shown["state"]).toBe("live");
  expect(Number(shown["yawDeg"])).toBeCloseTo(((yaw_deg ?? 0) + 360) % 360, 1);
  expect(Number(shown["pitchDeg"])).toBeCloseTo(pitch_deg ?? 0, 1);
  expect(Number(shown["rollDeg"])).toBeCloseTo(roll_deg ?? 0, 1);
});

test.each(ATTITUDES)("with a zero the yaw counts from it, pitch and roll stay: %d %d %d", (...angles) => {
  hear("ahrs", angles, 100);
  scene.setZero(50);
  const shown = look("ahrs", 100);
  expect(Number(shown["yawDeg"])).toBeCloseTo(((angles[0] ?? 0) - 50 + 720) % 360, 1);
  expect(Number(shown["pitchDeg"])).toBeCloseTo(angles[1] ?? 0, 1);
  expect(Number(shown["rollDeg"])).toBeCloseTo(angles[2] ?? 0, 1);
});

describe("what is not live", () => {
  test("has no numbers, and is called stale", () => {
    hear("ahrs", [27, 8, -12], 100);
    look("ahrs", 100);
    const shown = look("ahrs", 5000);
    expect(shown["state"]).toBe("stale");
    expect(shown["yawDeg"]).toBeUndefined();
    expect(shown["pitchDeg"]).toBeUndefined();
  });

  test("is none before anything was heard, and when an angle is missing", () => {
    expect(look("ahrs", 50)["state"]).toBe("none");
    hear("ahrs", [27, null, -12], 100);
    expect(look("ahrs", 100)["state"]).toBe("none");
  });

  test("of the one source says nothing of the other", () => {
    hear("ahrs", [27, 8, -12], 100);
    look("ahrs", 100);
    expect(look("ahrs_test", 150)["state"]).toBe("none");
    hear("ahrs_test", [91, 1, 2], 200);
    expect(look("ahrs_test", 200)).toMatchObject({ state: "live", yawDeg: "91.0" });
  });
});

test("nothing is told anew until another picture has been drawn", () => {
  hear("ahrs", [27, 8, -12], 100);
  look("ahrs", 100);
  hear("ahrs", [29, 8, -12], 120);
  feed.feed(telemetry, "ahrs", null, 120);
  scene.advance(620);
  feed.tell(dataset, pictures);
  expect(dataset["yawDeg"]).toBe("27.0");
  feed.tell(dataset, pictures + 1);
  expect(dataset).toMatchObject({ yawDeg: "29.0", pictures: `${pictures + 1}` });
});

test("nothing new asks for no picture", () => {
  hear("ahrs", [27, 8, -12], 100);
  look("ahrs", 100);
  const before = changes;
  look("ahrs", 116);
  look("ahrs", 133);
  expect(changes).toBe(before);
  hear("ahrs", [28, 8, -12], 150);
  look("ahrs", 150);
  expect(changes).toBe(before + 1);
});

test("a camera behind stands behind the heading of the first sample", () => {
  hear("ahrs", [90, 0, 0], 100);
  feed.feed(telemetry, "ahrs", "behind", 100);
  scene.advance(100);
  const { x, y, z } = scene.camera.position;
  // Behind an aircraft that flies east is west of it, and a little above.
  expect(x).toBeLessThan(-4);
  expect(Math.abs(z)).toBeLessThan(0.01);
  expect(y).toBeGreaterThan(0);
});

test.each([
  ["front", (x: number) => x > 4],
  ["side", (_: number, z: number) => z > 4],
  ["top", (_: number, __: number, y: number) => y > 4],
] as const)("the camera at the %s of an aircraft that flies east stands there", (view, holds) => {
  hear("ahrs", [90, 0, 0], 100);
  feed.feed(telemetry, "ahrs", view, 100);
  scene.advance(100);
  const { x, y, z } = scene.camera.position;
  expect(holds(x, z, y)).toBe(true);
});
