import { expect, test } from "vitest";
import {
  convertUnit,
  degreesFromRadians,
  feetFromMetres,
  roundLength,
  type UnitName,
  wrap360,
} from "./units";

test("a half turn is 180 degrees", () => {
  expect(degreesFromRadians(Math.PI)).toBeCloseTo(180, 12);
});

test("a foot is 0.3048 metres exactly", () => {
  expect(feetFromMetres(304.8)).toBeCloseTo(1000, 9);
});

test.each<[number, UnitName, number, UnitName]>([
  [1000, "ft", 304.8, "m"],
  [1, "nm", 1852, "m"],
  [18_520, "m", 10, "nm"],
  [1500, "m", 1.5, "km"],
  [100, "kt", 185.2, "kmPerH"],
  [36, "kmPerH", 10, "mPerS"],
  [-500, "ftPerMin", -2.54, "mPerS"],
  [0, "degC", 32, "degF"],
  [-40, "degF", -40, "degC"],
  [100, "degC", 212, "degF"],
])("%d %s are %d %s, and back", (value, from, expected, to) => {
  expect(convertUnit(value, from, to)).toBeCloseTo(expected, 9);
  expect(convertUnit(expected, to, from)).toBeCloseTo(value, 9);
});

test("a value in its own unit is not touched by any rounding", () => {
  expect(convertUnit(0.1, "kt", "kt")).toBe(0.1);
});

test.each([
  [0, 0],
  [360, 0],
  [-0, 0],
  [-90, 270],
  [-180, 180],
  [725, 5],
  [-1e-15, 0],
  [359.9996, 359.9996],
])("%d degrees is heading %d", (angle_deg, heading_deg) => {
  expect(wrap360(angle_deg)).toBe(heading_deg);
});

test("a heading is never 360 nor negative", () => {
  for (let angle_deg = -1000; angle_deg <= 1000; angle_deg += 0.37) {
    const heading_deg = wrap360(angle_deg);
    expect(heading_deg).toBeGreaterThanOrEqual(0);
    expect(heading_deg).toBeLessThan(360);
  }
});

test.each([
  [1, 1],
  [1.99, 1],
  [4.9, 2],
  [99, 50],
  [0.3, 0.2],
  [123_456, 100_000],
])("of at most %s the round length is %s", (most, length) => {
  expect(roundLength(most)).toBeCloseTo(length, 9);
});
