import { expect, test } from "vitest";
import {
  areControls,
  PEDAL_TRAVEL,
  pedalShift,
  STICK_TRAVEL,
  stickShift,
  THROTTLE_TRAVEL,
  throttleShift,
} from "./geometry";

test("the stick goes right for the right wing down", () => {
  expect(stickShift(0.5, 0)).toEqual({ x: STICK_TRAVEL / 2, y: 0 });
});

test("the stick goes back, down the picture, for the nose up", () => {
  expect(stickShift(0, 1)).toEqual({ x: 0, y: STICK_TRAVEL });
  expect(stickShift(0, -1)).toEqual({ x: 0, y: -STICK_TRAVEL });
});

test("the pedals' mark goes right for the nose right", () => {
  expect(pedalShift(1)).toEqual({ x: PEDAL_TRAVEL });
});

test("the throttle goes up as it opens", () => {
  expect(throttleShift(0)).toEqual({ y: 0 });
  expect(throttleShift(1)).toEqual({ y: -THROTTLE_TRAVEL });
});

test("nothing leaves its track", () => {
  expect(stickShift(3, -3)).toEqual(stickShift(1, -1));
  expect(pedalShift(-2)).toEqual(pedalShift(-1));
  expect(throttleShift(1.2)).toEqual(throttleShift(1));
  expect(throttleShift(-1)).toEqual(throttleShift(0));
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
