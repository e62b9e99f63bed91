import { describe, expect, test } from "vitest";
import { formatAge, formatBytes, formatFixed, formatHeading, formatMeasured, WIRE_FIGURES } from "./format";

describe("a number", () => {
  test.each([
    [-1234.5, 1, "-1234.5"],
    [1234567.891, 2, "1234567.89"],
    [0.06, 1, "0.1"],
    [2.999, 2, "3.00"],
    [-0.04, 1, "0.0"],
    [27.7717781, 6, "27.771778"],
  ])("%d to %i digits keeps its sign and every figure: %s", (value, digits, text) => {
    expect(formatFixed(value, digits)).toBe(text);
  });

  test.each([Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, null, undefined])(
    "that is %s has no text, so it can never pass for a value",
    (value) => {
      expect(formatFixed(value, 1)).toBeNull();
      expect(formatHeading(value, 1)).toBeNull();
    },
  );
});

describe("any measured number", () => {
  test.each([
    [0, "0.0000"],
    [-0.00001, "0.0000"],
    [0.123456, "0.1235"],
    [-9.81, "-9.8100"],
    [101.325, "101.33"],
    [-1234.56, "-1234.6"],
    [654321.7, "654322"],
  ])("%d keeps five figures and all its digits before the point: %s", (value, text) => {
    expect(formatMeasured(value)).toBe(text);
  });

  test("with all figures of the wire tells a position to a metre", () => {
    expect(formatMeasured(-15.374123, WIRE_FIGURES)).toBe("-15.37412");
  });

  test("that is none has no text", () => {
    expect(formatMeasured(Number.NaN)).toBeNull();
    expect(formatMeasured(null)).toBeNull();
  });
});

describe("a heading", () => {
  test.each([
    [359.9996, 1, "0.0"],
    [359.94, 1, "359.9"],
    [-0.01, 1, "0.0"],
    [-170, 0, "190"],
    [360, 0, "0"],
  ])("of %d to %i digits reads %s", (heading_deg, digits, text) => {
    expect(formatHeading(heading_deg, digits)).toBe(text);
  });

  test("never reads 360", () => {
    for (let heading_deg = 359; heading_deg <= 361; heading_deg += 0.0007) {
      expect(formatHeading(heading_deg, 1)).not.toMatch(/^360/);
    }
  });
});

test("an age reads in the unit that suits it", () => {
  expect([0, 0.34, 9.94, 9.96, 59.4, 59.6, 3599, 7260, -3].map(formatAge)).toEqual([
    "0.0 s",
    "0.3 s",
    "9.9 s",
    "10 s",
    "59 s",
    "1 min",
    "1 h 0 min",
    "2 h 1 min",
    "0.0 s",
  ]);
});

test("bytes read with three figures", () => {
  expect([0, 999, 1000, 12_345, 999_600, 61_500_000].map(formatBytes)).toEqual([
    "0 B",
    "999 B",
    "1.00 kB",
    "12.3 kB",
    "1.00 MB",
    "61.5 MB",
  ]);
});
