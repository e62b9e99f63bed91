import { describe, expect, test } from "vitest";
import { PictureBudget } from "../pictureBudget";
import { softwareRatio, stageLimits } from "./stageBudget";

describe("how fine the processor draws", () => {
  test("while it moves, no finer than the page, and less so the larger it is", () => {
    expect(softwareRatio(300, 300, true)).toBe(1);
    expect(softwareRatio(660, 560, true)).toBeLessThan(1);
    expect(softwareRatio(900, 700, true)).toBeLessThan(softwareRatio(660, 560, true));
  });

  test("never so coarse that its words cannot be read", () => {
    expect(softwareRatio(3000, 2000, true)).toBe(0.6);
  });

  test("at rest finer than the page, which smooths its edges, where that is not too much", () => {
    expect(softwareRatio(660, 560, false)).toBe(2);
    expect(softwareRatio(3000, 2000, false)).toBe(1);
  });
});

test("without a graphics processor pictures stay dear, however short they seem", () => {
  const budget = new PictureBudget(true, stageLimits(true));
  for (let picture = 0; picture < 100; picture += 1) {
    budget.observe(3);
  }
  expect(budget.period_ms(false)).toBe(80);
});

test("on a graphics processor some slow pictures pass", () => {
  const budget = new PictureBudget(false, stageLimits(false));
  for (let picture = 0; picture < 100; picture += 1) {
    budget.observe(90);
  }
  expect(budget.period_ms(false)).toBeGreaterThan(0);
  for (let picture = 0; picture < 100; picture += 1) {
    budget.observe(17);
  }
  expect(budget.period_ms(false)).toBe(0);
});
