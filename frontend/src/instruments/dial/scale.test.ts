import { describe, expect, test } from "vitest";
import { clamp, isDrawable, polar, reach, type Scale, scaleAngle_deg, series, tickPath } from "./scale";

const CLOCKWISE: Scale = { minimum: 0, maximum: 160, start_deg: 0, sweep_deg: 330 };
const ANTICLOCKWISE: Scale = { minimum: -1, maximum: 1, start_deg: 90, sweep_deg: -180 };

test("values spread evenly between the ends, in the scale's own direction", () => {
  expect(scaleAngle_deg(CLOCKWISE, 0)).toBe(0);
  expect(scaleAngle_deg(CLOCKWISE, 80)).toBe(165);
  expect(scaleAngle_deg(CLOCKWISE, 160)).toBe(330);
  expect(scaleAngle_deg(ANTICLOCKWISE, -1)).toBe(90);
  expect(scaleAngle_deg(ANTICLOCKWISE, 0)).toBe(0);
  expect(scaleAngle_deg(ANTICLOCKWISE, 1)).toBe(-90);
});

test("beyond an end the pointer rests on that end and never comes round again", () => {
  expect(scaleAngle_deg(CLOCKWISE, 175)).toBe(330);
  expect(scaleAngle_deg(CLOCKWISE, 1e9)).toBe(330);
  expect(scaleAngle_deg(CLOCKWISE, -20)).toBe(0);
});

test("a value on an end is still within, one past it is not", () => {
  expect([-0.001, 0, 160, 160.001].map((value) => reach(0, 160, value))).toEqual([
    "below",
    "within",
    "within",
    "above",
  ]);
});

describe("what can be drawn", () => {
  test.each([null, undefined, Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY])(
    "%s is no data",
    (value) => {
      expect(isDrawable(value)).toBe(false);
    },
  );

  test.each([0, -0, -12.5, 1e30])("%d is a value", (value) => {
    expect(isDrawable(value)).toBe(true);
  });
});

test("angles run clockwise from twelve o'clock with y down", () => {
  expect(polar(10, 0)).toEqual({ x: 0, y: -10 });
  expect(polar(10, 90)).toEqual({ x: 10, y: 0 });
  expect(polar(10, 180)).toEqual({ x: 0, y: 10 });
  expect(polar(10, 270)).toEqual({ x: -10, y: 0 });
});

test("ticks are strokes from the outer radius to the inner one", () => {
  expect(tickPath([0, 90], 80, 88)).toBe("M0 -88L0 -80M88 0L80 0");
});

test("a series holds both ends and gathers no rounding", () => {
  expect(series(0, 330, 30)).toHaveLength(12);
  expect(series(-90, 90, 2.5).at(-1)).toBe(90);
  expect(series(0, 1, 0.1)).toHaveLength(11);
});

test("clamping keeps to the range", () => {
  expect([clamp(-2, -1, 1), clamp(0.5, -1, 1), clamp(7, -1, 1)]).toEqual([-1, 0.5, 1]);
});
