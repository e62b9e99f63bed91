import { expect, test } from "vitest";
import { RedrawBudget } from "./paintBudget";

const ANIMATION_FRAME_MS = 1000 / 60;

function after(budget: RedrawBudget, frames: number, cost_ms: number): RedrawBudget {
  for (let frame = 0; frame < frames; frame += 1) {
    budget.observe(cost_ms);
  }
  return budget;
}

/** How often instruments move at 60 animation frames a second: in every first, second or third. */
function everyNth(budget: RedrawBudget): number {
  return Math.max(1, Math.ceil(budget.period_ms / ANIMATION_FRAME_MS));
}

test("where animation frames are cheap instruments move in every one", () => {
  expect(after(new RedrawBudget(), 600, 2).period_ms).toBe(0);
});

test("where animation frames are dear they move thirty times a second, where they are dearer twenty times and never less", () => {
  expect(everyNth(after(new RedrawBudget(), 600, 5))).toBe(2);
  expect(everyNth(after(new RedrawBudget(), 600, 9))).toBe(3);
  expect(everyNth(after(new RedrawBudget(), 600, 90))).toBe(3);
});

test("an animation frame that comes a little early is not let go by", () => {
  expect(after(new RedrawBudget(), 600, 5).period_ms).toBeLessThan(2 * ANIMATION_FRAME_MS - 3);
  expect(after(new RedrawBudget(), 600, 9).period_ms).toBeLessThan(3 * ANIMATION_FRAME_MS - 3);
});

test("one slow animation frame changes nothing", () => {
  const budget = after(new RedrawBudget(), 600, 2);
  budget.observe(12);
  expect(budget.period_ms).toBe(0);
});

test("a little less than what made it slow does not make it fast, so that it does not go to and fro", () => {
  expect(everyNth(after(after(new RedrawBudget(), 600, 9), 600, 6))).toBe(3);
  expect(everyNth(after(after(new RedrawBudget(), 600, 5), 600, 2.5))).toBe(2);
  expect(everyNth(after(new RedrawBudget(), 600, 2.5))).toBe(1);
});

test("when animation frames become cheap again it goes back to every one", () => {
  expect(after(after(new RedrawBudget(), 600, 9), 600, 1.5).period_ms).toBe(0);
});

test("its period is two or three animation frames, less what one may come early", () => {
  expect(after(new RedrawBudget(), 600, 5).period_ms).toBeCloseTo(2 * ANIMATION_FRAME_MS - 4, 9);
  expect(after(new RedrawBudget(), 600, 9).period_ms).toBeCloseTo(3 * ANIMATION_FRAME_MS - 4, 9);
});

test("however cheap animation frames are, there is no faster than every one, and one dear again is slow again", () => {
  const budget = after(new RedrawBudget(), 600, 0.1);
  expect(budget.period_ms).toBe(0);
  expect(everyNth(after(budget, 600, 5))).toBe(2);
});
