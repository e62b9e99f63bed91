import { describe, expect, test } from "vitest";
import { attitudeOf, quaternionOf } from "./attitude";
import { AttitudeMotion } from "./attitudeMotion";

function yaw(yaw_deg: number) {
  return quaternionOf({ yaw_deg, pitch_deg: 0, roll_deg: 0 });
}

function shownYaw(motion: AttitudeMotion, now_ms: number): number | null {
  const turn = motion.shown(now_ms);
  return turn === null ? null : attitudeOf(turn).yaw_deg;
}

/** Samples each `period_ms` that turn ten degrees a second; returns the time of the last. */
function turning(motion: AttitudeMotion, period_ms: number, count: number): number {
  for (let index = 0; index < count; index += 1) {
    motion.push(yaw(20 + 0.01 * index * period_ms), 1000 + index * period_ms);
  }
  return 1000 + (count - 1) * period_ms;
}

describe("the attitude between samples", () => {
  test("is none before the first, which is shown at once", () => {
    const motion = new AttitudeMotion();
    expect(motion.shown(0)).toBeNull();
    motion.push(yaw(40), 1000);
    expect(shownYaw(motion, 1000)).toBeCloseTo(40, 6);
  });

  test("goes on evenly at any rate, and is never further behind than one period", () => {
    for (const period_ms of [20, 100]) {
      const motion = new AttitudeMotion();
      const end_ms = turning(motion, period_ms, 60);
      const first = shownYaw(motion, end_ms) ?? 0;
      const middle = shownYaw(motion, end_ms + period_ms / 2) ?? 0;
      const last = shownYaw(motion, end_ms + period_ms) ?? 0;
      expect(middle - first).toBeCloseTo(last - middle, 2);
      expect(last - first).toBeCloseTo(0.01 * period_ms, 1);
      expect(last).toBeCloseTo(20 + 0.01 * (end_ms - 1000), 3);
    }
  });

  test("is still when the last sample is reached", () => {
    const motion = new AttitudeMotion();
    const end_ms = turning(motion, 100, 30);
    expect(motion.isMoving(end_ms + 10, false)).toBe(true);
    expect(motion.isMoving(end_ms + 300, false)).toBe(false);
  });

  test("does not make up a way across a gap, nor from another source", () => {
    const motion = new AttitudeMotion();
    const end_ms = turning(motion, 100, 10);
    motion.push(yaw(200), end_ms + 2000);
    expect(shownYaw(motion, end_ms + 2000)).toBeCloseTo(200, 6);
    motion.clear();
    motion.push(yaw(90), end_ms + 2020);
    expect(shownYaw(motion, end_ms + 2020)).toBeCloseTo(90, 6);
  });
});

describe("the ghost", () => {
  test("is where the aircraft was a second ago", () => {
    const motion = new AttitudeMotion();
    const end_ms = turning(motion, 100, 40);
    const ghost = motion.ghost(end_ms + 30);
    expect(ghost === null ? null : attitudeOf(ghost).yaw_deg).toBeCloseTo(
      20 + 0.01 * (end_ms + 30 - 2000),
      4,
    );
  });

  test("is not there in the first second", () => {
    const motion = new AttitudeMotion();
    const end_ms = turning(motion, 100, 5);
    expect(motion.ghost(end_ms)).toBeNull();
    expect(motion.ghost(end_ms + 1100)).not.toBeNull();
  });

  test("moves on for a second after the aircraft stands still, and then rests", () => {
    const motion = new AttitudeMotion();
    const end_ms = turning(motion, 100, 30);
    expect(motion.isMoving(end_ms + 500, true)).toBe(true);
    expect(motion.isMoving(end_ms + 1100, true)).toBe(false);
  });

  test("keeps no more of the past than it needs", () => {
    const motion = new AttitudeMotion();
    const end_ms = turning(motion, 20, 3000);
    const ghost = motion.ghost(end_ms);
    expect(ghost === null ? null : attitudeOf(ghost).yaw_deg).toBeCloseTo(
      attitudeOf(yaw(20 + 0.01 * (end_ms - 2000))).yaw_deg,
      3,
    );
  });
});

describe("nothing received", () => {
  test("is nothing shown, no ghost and nothing that moves", () => {
    const motion = new AttitudeMotion();
    expect(motion.ghost(5000)).toBeNull();
    expect(motion.isMoving(5000, true)).toBe(false);
  });

  test("since the source changed is the same, whatever came before", () => {
    const motion = new AttitudeMotion();
    const end_ms = turning(motion, 100, 30);
    motion.clear();
    expect(motion.shown(end_ms)).toBeNull();
    expect(motion.ghost(end_ms)).toBeNull();
    expect(motion.isMoving(end_ms, true)).toBe(false);
  });
});

test("a single sample moves until its ghost has come, and not for who draws no ghost", () => {
  const motion = new AttitudeMotion();
  motion.push(yaw(40), 1000);
  expect(motion.isMoving(1500, true)).toBe(true);
  expect(motion.isMoving(1500, false)).toBe(false);
  expect(motion.isMoving(2001, true)).toBe(false);
});
