import { expect, test } from "vitest";
import { RedrawBudget } from "./budget";

function after(budget: RedrawBudget, frames: number, cost_ms: number): RedrawBudget {
  for (let frame = 0; frame < frames; frame += 1) {
    budget.observe(cost_ms);
  }
  return budget;
}

test("where frames are cheap instruments move in every one", () => {
  expect(after(new RedrawBudget(), 600, 2).period_ms).toBe(0);
});

test("where frames are dear they move thirty times a second", () => {
  const { period_ms } = after(new RedrawBudget(), 600, 8);
  expect(period_ms).toBeGreaterThan(1000 / 60);
  expect(period_ms).toBeLessThan(1000 / 30);
});

test("one slow frame changes nothing", () => {
  const budget = after(new RedrawBudget(), 600, 2);
  budget.observe(40);
  expect(budget.period_ms).toBe(0);
});

test("between cheap and dear it stays as it is, so that it does not go to and fro", () => {
  expect(after(after(new RedrawBudget(), 600, 8), 600, 4).period_ms).toBeGreaterThan(0);
  expect(after(after(new RedrawBudget(), 600, 2), 600, 4).period_ms).toBe(0);
});

test("when frames become cheap again it goes back to every one", () => {
  expect(after(after(new RedrawBudget(), 600, 8), 600, 2).period_ms).toBe(0);
});
