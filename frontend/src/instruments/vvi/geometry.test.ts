import { expect, test } from "vitest";
import { VERTICAL_SPEED_GEOMETRY } from "./geometry";

const { pointerAngle_deg, reach, numerals } = VERTICAL_SPEED_GEOMETRY.ftPerMin;

/** Height of the pointer's tip over the middle, for a pointer of length 1. */
function tipHeight(vertical_speed_ft_min: number): number {
  return Math.cos((pointerAngle_deg(vertical_speed_ft_min) * Math.PI) / 180);
}

test("level flight points to nine o'clock", () => {
  expect(pointerAngle_deg(0)).toBe(-90);
});

test("a climb raises the pointer and a descent lowers it, by the same angle", () => {
  expect(tipHeight(500)).toBeGreaterThan(0);
  expect(tipHeight(-500)).toBeLessThan(0);
  expect(pointerAngle_deg(500) + 90).toBeCloseTo(-(pointerAngle_deg(-500) + 90), 9);
});

test("it stops at 2000 either way and says so, and the two ends are apart", () => {
  expect(pointerAngle_deg(2600)).toBe(pointerAngle_deg(2000));
  expect(pointerAngle_deg(-9000)).toBe(pointerAngle_deg(-2000));
  expect(pointerAngle_deg(2000) - pointerAngle_deg(-2000)).toBe(330);
  expect([reach(2000), reach(2001), reach(-2000), reach(-2001)]).toEqual([
    "within",
    "above",
    "within",
    "below",
  ]);
});

test("both halves are numbered in hundreds of feet per minute", () => {
  expect(numerals.map(({ text }) => text)).toEqual(["20", "15", "10", "5", "0", "5", "10", "15", "20"]);
});

test("a face in metres per second ends at ten, painted in feet per minute", () => {
  const metric = VERTICAL_SPEED_GEOMETRY.mPerS;
  expect(metric.pointerAngle_deg(0)).toBe(-90);
  expect(metric.pointerAngle_deg(10 / 0.00508)).toBeCloseTo(75, 6);
  expect([metric.reach(1960), metric.reach(1980)]).toEqual(["within", "above"]);
  expect(metric.numerals.map(({ text }) => text).join()).toBe("10,8,6,4,2,0,2,4,6,8,10");
});
