import { expect, test } from "vitest";
import { ALTITUDE_GEOMETRY, ALTITUDE_MAXIMUM_FT, ALTITUDE_MINIMUM_FT } from "./geometry";

const { pointerAngle_deg, reach, numerals } = ALTITUDE_GEOMETRY.ft;

test("a thousand feet are one turn", () => {
  expect(pointerAngle_deg(0)).toBe(0);
  expect(pointerAngle_deg(250)).toBe(90);
  expect(pointerAngle_deg(1000)).toBe(360);
  expect(pointerAngle_deg(2500)).toBe(900);
});

test("the pointer passes the top without a jump, up and down", () => {
  for (const altitude_ft of [0, 1000, 5000, -1000]) {
    const step_deg = pointerAngle_deg(altitude_ft + 1) - pointerAngle_deg(altitude_ft - 1);
    expect(step_deg).toBeCloseTo(0.72, 6);
  }
});

test("below sea level it turns on, anticlockwise", () => {
  expect(pointerAngle_deg(-100)).toBe(-36);
  expect(reach(-100)).toBe("within");
});

test("it stops at both ends of what the window can hold", () => {
  expect(pointerAngle_deg(ALTITUDE_MAXIMUM_FT + 5000)).toBe(pointerAngle_deg(ALTITUDE_MAXIMUM_FT));
  expect(pointerAngle_deg(ALTITUDE_MINIMUM_FT - 5000)).toBe(pointerAngle_deg(ALTITUDE_MINIMUM_FT));
  expect(reach(ALTITUDE_MAXIMUM_FT + 1)).toBe("above");
  expect(reach(ALTITUDE_MINIMUM_FT - 1)).toBe("below");
});

test("the hundreds are numbered 0 to 9 round the dial", () => {
  expect(numerals.map(({ text }) => text).join("")).toBe("0123456789");
});

test("on a face in metres a thousand metres are one turn, painted in feet", () => {
  expect(ALTITUDE_GEOMETRY.m.pointerAngle_deg(1000 / 0.3048)).toBeCloseTo(360, 9);
  expect(ALTITUDE_GEOMETRY.m.reach(ALTITUDE_MAXIMUM_FT + 1)).toBe("above");
});
