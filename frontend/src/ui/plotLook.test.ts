import type uPlot from "uplot";
import { expect, test } from "vitest";
import { axisNumber, steady } from "./plotLook";

const PLOT = {} as uPlot;

test("a noise does not fill the picture, and the ends are round numbers", () => {
  expect(steady(10)(PLOT, 99.98, 100.02)).toEqual([94, 106]);
  expect(steady(10)(PLOT, null, null)).toEqual([-6, 6]);
});

test("the axis stands still until a value leaves it", () => {
  const [low, high] = steady(10)(PLOT, 100, 340);
  expect([low, high]).toEqual([100, 350]);
  expect(steady(10)(PLOT, 101, 349)).toEqual([100, 350]);
  expect(steady(10)(PLOT, 101, 351)).toEqual([100, 400]);
});

test("an axis has a decimal point, no mark between thousands, and the digits of its step", () => {
  const shown = [
    [0.25, 0.25],
    [-0.2, 0.1],
    [1500, 500],
    [1500.5, 2.5],
    [-0, 0.5],
    [0.3, 0.1],
    [1e-7, 5e-8],
  ].map(([value = 0, step = 1]) => axisNumber(value, step));
  expect(shown).toEqual(["0.25", "-0.2", "1500", "1500.5", "0.0", "0.3", "0.00000010"]);
});
