import { describe, expect, test } from "vitest";
import { FrameBudget } from "../frameBudget";
import { GLOBE_LIMITS } from "./budget";

/** A budget after many frames of this cost. */
function having(cost_ms: number, startsDear = false): FrameBudget {
  const budget = new FrameBudget(startsDear, GLOBE_LIMITS);
  for (let frame = 0; frame < 60; frame += 1) {
    budget.observe(cost_ms);
  }
  return budget;
}

describe("on a graphics processor", () => {
  test("every displayed frame may be drawn", () => {
    expect(having(6).period_ms(false)).toBe(0);
  });

  test("one slow frame changes nothing", () => {
    const budget = having(6);
    budget.observe(150);
    expect(budget.period_ms(false)).toBe(0);
  });

  test("a browser that spoke of software drawing is believed no longer", () => {
    expect(new FrameBudget(true, GLOBE_LIMITS).period_ms(false)).toBeGreaterThan(0);
    expect(having(6, true).period_ms(false)).toBe(0);
  });
});

describe("without one", () => {
  test.each([60, 80, 120, 170, 300])("at %i ms a frame two to five are drawn in a second", (cost_ms) => {
    const period_ms = having(cost_ms).period_ms(false);
    expect(period_ms).toBeGreaterThanOrEqual(199);
    expect(period_ms).toBeLessThanOrEqual(501);
  });

  test("most of the time is left to the instruments where a frame allows it", () => {
    expect(60 / having(60).period_ms(false)).toBeLessThan(0.36);
    expect(150 / having(150).period_ms(false)).toBeLessThan(0.36);
  });

  test("a third of the time is left even where a frame takes a second", () => {
    expect(1000 / having(1000).period_ms(false)).toBeLessThan(0.67);
  });

  test("it is drawn more often while a person turns it", () => {
    const budget = having(80);
    expect(budget.period_ms(true)).toBeLessThan(budget.period_ms(false));
    expect(budget.period_ms(true)).toBeGreaterThanOrEqual(100);
  });
});
