import { expect, test } from "vitest";
import {
  areControls,
  PEDAL_TRAVEL,
  pedalTransform,
  STICK_TRAVEL,
  stickTransform,
  THROTTLE_TRAVEL,
  throttleTransform,
} from "./geometry";

test("the stick goes right for the right wing down", () => {
  expect(stickTransform(0.5, 0)).toBe(`translate(${STICK_TRAVEL / 2} 0)`);
});

test("the stick goes back, down the picture, for the nose up", () => {
  expect(stickTransform(0, 1)).toBe(`translate(0 ${STICK_TRAVEL})`);
  expect(stickTransform(0, -1)).toBe(`translate(0 -${STICK_TRAVEL})`);
});

test("the pedals' mark goes right for the nose right", () => {
  expect(pedalTransform(1)).toBe(`translate(${PEDAL_TRAVEL} 0)`);
});

test("the throttle goes up as it opens", () => {
  expect(throttleTransform(0)).toBe("translate(0 0)");
  expect(throttleTransform(1)).toBe(`translate(0 -${THROTTLE_TRAVEL})`);
});

test("nothing leaves its track", () => {
  expect(stickTransform(3, -3)).toBe(stickTransform(1, -1));
  expect(pedalTransform(-2)).toBe(pedalTransform(-1));
  expect(throttleTransform(1.2)).toBe(throttleTransform(1));
  expect(throttleTransform(-1)).toBe(throttleTransform(0));
});

test("one missing control makes the picture incomplete", () => {
  const all = { aileron: 0, elevator: 0, rudder: 0, throttle: 0 };
  expect(areControls(all)).toBe(true);
  expect(areControls(null)).toBe(false);
  for (const axis of ["aileron", "elevator", "rudder", "throttle"]) {
    expect(areControls({ ...all, [axis]: null })).toBe(false);
    expect(areControls({ ...all, [axis]: Number.NaN })).toBe(false);
  }
});
