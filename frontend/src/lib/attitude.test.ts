import { describe, expect, test } from "vitest";
import {
  angleBetween_deg,
  attitudeOf,
  between,
  type FullAttitude,
  inPicture,
  quaternionOf,
  rotated,
  turnFromPicture,
  turnInPicture,
  type Vector,
} from "./attitude";

const RADIAN = 180 / Math.PI;
const sin = (angle_deg: number): number => Math.sin(angle_deg / RADIAN);
const cos = (angle_deg: number): number => Math.cos(angle_deg / RADIAN);

/** Thirty attitudes: simple ones that can be imagined, and others in all directions. */
const ATTITUDES: FullAttitude[] = [
  [0, 0, 0],
  [90, 0, 0],
  [180, 0, 0],
  [270, 0, 0],
  [0, 30, 0],
  [0, -30, 0],
  [0, 0, 45],
  [0, 0, -45],
  [0, 0, 180],
  [90, 20, 60],
  ...Array.from({ length: 20 }, (_, index): [number, number, number] => [
    (index * 47) % 360,
    -80 + ((index * 37) % 161),
    -175 + ((index * 83) % 351),
  ]),
].map(([yaw_deg = 0, pitch_deg = 0, roll_deg = 0]) => ({ yaw_deg, pitch_deg, roll_deg }));

/** Directions of nose, right wing and belly by spherical geometry, without rotations of axes. */
function byTrigonometry({ yaw_deg, pitch_deg, roll_deg }: FullAttitude): { nose: Vector; right: Vector } {
  const nose: Vector = [cos(pitch_deg) * cos(yaw_deg), cos(pitch_deg) * sin(yaw_deg), -sin(pitch_deg)];
  // Wings level: the right wing lies in the horizon, a right angle clockwise of the nose.
  const level: Vector = [-sin(yaw_deg), cos(yaw_deg), 0];
  // The belly of a level aircraft: from straight down, aft by the pitch.
  const belly: Vector = [sin(pitch_deg) * cos(yaw_deg), sin(pitch_deg) * sin(yaw_deg), cos(pitch_deg)];
  const [n, e, d] = [0, 1, 2].map(
    (axis) => cos(roll_deg) * (level[axis] ?? 0) + sin(roll_deg) * (belly[axis] ?? 0),
  );
  return { nose, right: [n ?? 0, e ?? 0, d ?? 0] };
}

function expectNear(found: readonly number[], wanted: readonly number[]): void {
  expect(Math.max(...found.map((part, index) => Math.abs(part - (wanted[index] ?? 0))))).toBeLessThan(1e-9);
}

describe.each(ATTITUDES)("yaw $yaw_deg, pitch $pitch_deg, roll $roll_deg", (attitude) => {
  const turn = quaternionOf(attitude);

  test("puts nose and right wing where trigonometry has them", () => {
    const { nose, right } = byTrigonometry(attitude);
    expectNear(rotated(turn, [1, 0, 0]), nose);
    expectNear(rotated(turn, [0, 1, 0]), right);
  });

  test("turns the same in the axes of the picture", () => {
    const { nose, right } = byTrigonometry(attitude);
    const picture = turnInPicture(turn);
    expectNear(rotated(picture, inPicture([1, 0, 0])), inPicture(nose));
    expectNear(rotated(picture, inPicture([0, 1, 0])), inPicture(right));
    expect(turnFromPicture(picture)).toEqual(turn);
  });

  test("is found again from the turn", () => {
    const found = attitudeOf(turn);
    expect(angleBetween_deg(quaternionOf(found), turn)).toBeLessThan(1e-5);
    expect(found.pitch_deg).toBeCloseTo(attitude.pitch_deg, 6);
    expect(Math.abs(((found.yaw_deg - attitude.yaw_deg + 540) % 360) - 180)).toBeLessThan(1e-6);
    expect(Math.abs(((found.roll_deg - attitude.roll_deg + 540) % 360) - 180)).toBeLessThan(1e-6);
  });
});

test("nose up is up in the picture, right wing down is down, a heading of east is to the right", () => {
  const up = rotated(turnInPicture(quaternionOf({ yaw_deg: 0, pitch_deg: 20, roll_deg: 0 })), [0, 0, -1]);
  expect(up[1]).toBeGreaterThan(0.3);
  const wing = rotated(turnInPicture(quaternionOf({ yaw_deg: 0, pitch_deg: 0, roll_deg: 20 })), [1, 0, 0]);
  expect(wing[1]).toBeLessThan(-0.3);
  const east = rotated(turnInPicture(quaternionOf({ yaw_deg: 90, pitch_deg: 0, roll_deg: 0 })), [0, 0, -1]);
  expectNear(east, [1, 0, 0]);
});

test("straight up keeps the turn, though it has no heading", () => {
  const turn = quaternionOf({ yaw_deg: 30, pitch_deg: 90, roll_deg: 20 });
  const found = attitudeOf(turn);
  expect(found.pitch_deg).toBeCloseTo(90, 4);
  expect(angleBetween_deg(quaternionOf(found), turn)).toBeLessThan(0.05);
});

test("the way between two turns is the shorter one, at an even speed", () => {
  const from = quaternionOf({ yaw_deg: 350, pitch_deg: 0, roll_deg: 0 });
  const to = quaternionOf({ yaw_deg: 30, pitch_deg: 0, roll_deg: 0 });
  for (const share of [0, 0.25, 0.5, 1]) {
    expect(attitudeOf(between(from, to, share)).yaw_deg).toBeCloseTo((350 + 40 * share) % 360, 6);
  }
});

test("the angle between turns is exact where it is small, and the same whatever the signs", () => {
  const still = quaternionOf({ yaw_deg: 0, pitch_deg: 0, roll_deg: 0 });
  const tiny = quaternionOf({ yaw_deg: 0, pitch_deg: 0.001, roll_deg: 0 });
  expect(angleBetween_deg(still, tiny)).toBeCloseTo(0.001, 9);
  const [x, y, z, w] = quaternionOf({ yaw_deg: 120, pitch_deg: 0, roll_deg: 0 });
  expect(angleBetween_deg(still, [-x, -y, -z, -w])).toBeCloseTo(120, 9);
});

test("between two turns that nearly coincide the way is straight, and each turn on it has length one", () => {
  const from = quaternionOf({ yaw_deg: 0, pitch_deg: 0, roll_deg: 0 });
  const to = quaternionOf({ yaw_deg: 0.004, pitch_deg: 0, roll_deg: 0 });
  for (const share of [0, 0.25, 1]) {
    const turn = between(from, to, share);
    expect(Math.hypot(...turn)).toBeCloseTo(1, 12);
    expect(angleBetween_deg(from, turn)).toBeCloseTo(0.004 * share, 9);
  }
  const far = quaternionOf({ yaw_deg: 120, pitch_deg: 30, roll_deg: -60 });
  expect(Math.hypot(...between(from, far, 0.3))).toBeCloseTo(1, 12);
});
