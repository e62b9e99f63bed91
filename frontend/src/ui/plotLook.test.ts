import type uPlot from "uplot";
import { expect, test } from "vitest";
import { steady } from "./plotLook";

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
