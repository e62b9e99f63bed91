import { describe, expect, test } from "vitest";
import { PictureBudget } from "../pictureBudget";
import { globeLimits, softwareScale } from "./globeBudget";

/** A budget after many pictures of this cost. */
function having(cost_ms: number, isSoftware = false): PictureBudget {
  const budget = new PictureBudget(isSoftware, globeLimits(isSoftware));
  for (let picture = 0; picture < 60; picture += 1) {
    budget.observe(cost_ms);
  }
  return budget;
}

describe("on a graphics processor", () => {
  test("every animation frame may be drawn", () => {
    expect(having(6).period_ms(false)).toBe(0);
  });

  test("one slow picture changes nothing", () => {
    const budget = having(6);
    budget.observe(150);
    expect(budget.period_ms(false)).toBe(0);
  });
});

describe("drawn by the processor alone", () => {
  test.each([5, 30, 45, 60, 85])("at %i ms a picture four to eight are drawn in a second", (cost_ms) => {
    const period_ms = having(cost_ms, true).period_ms(false);
    expect(period_ms).toBeGreaterThanOrEqual(124);
    expect(period_ms).toBeLessThanOrEqual(251);
  });

  test("the browser's word is believed, however fast the pictures are", () => {
    expect(having(6, true).isDear).toBe(true);
  });

  test("a third of the time is left, and a map with pictures of half a second does not look dead", () => {
    expect(200 / having(200, true).period_ms(false)).toBeLessThan(0.67);
    expect(having(500, true).period_ms(false)).toBeLessThan(1001);
  });

  test("while something moves the picture is coarser on a greater map, and never too coarse to be read", () => {
    expect(softwareScale(679, 598, true)).toBeGreaterThan(softwareScale(800, 700, true));
    expect(softwareScale(400, 300, true)).toBe(0.75);
    expect(softwareScale(3000, 1900, true)).toBe(0.7);
  });

  test("at rest a picture is as fine as the page, but for a very great one", () => {
    expect(softwareScale(1230, 920, false)).toBe(1);
    expect(softwareScale(2200, 1000, false)).toBeLessThan(0.9);
  });
});

describe("on a slow graphics processor", () => {
  test.each([60, 80, 120, 170, 300])("at %i ms a picture two to five are drawn in a second", (cost_ms) => {
    const period_ms = having(cost_ms).period_ms(false);
    expect(period_ms).toBeGreaterThanOrEqual(199);
    expect(period_ms).toBeLessThanOrEqual(501);
  });

  test("most of the time is left to the instruments where a picture allows it", () => {
    expect(60 / having(60).period_ms(false)).toBeLessThan(0.36);
    expect(150 / having(150).period_ms(false)).toBeLessThan(0.36);
  });

  test("a third of the time is left even where a picture takes a second", () => {
    expect(1000 / having(1000).period_ms(false)).toBeLessThan(0.67);
  });

  test("it is drawn more often while a person turns it", () => {
    const budget = having(80);
    expect(budget.period_ms(true)).toBeLessThan(budget.period_ms(false));
    expect(budget.period_ms(true)).toBeGreaterThanOrEqual(100);
  });
});
