import { expect, test } from "vitest";
import { RedrawBudget } from "./paintBudget";

const FRAME_MS = 1000 / 60;

function after(budget: RedrawBudget, frames: number, cost_ms: number): RedrawBudget {
  for (let frame = 0; frame < frames; frame += 1) {
    budget.observe(cost_ms);
  }
  return budget;
}

/** How often instruments move at 60 animation frames a second: in every first, second or third. */
function everyFrames(budget: RedrawBudget): number {
  return Math.max(1, Math.ceil(budget.period_ms / FRAME_MS));
}

test("where frames are cheap instruments move in every one", () => {
  expect(after(new RedrawBudget(), 600, 2).period_ms).toBe(0);
});

test("where frames are dear they move thirty times a second, where they are dearer twenty times and never less", () => {
  expect(everyFrames(after(new RedrawBudget(), 600, 5))).toBe(2);
  expect(everyFrames(after(new RedrawBudget(), 600, 9))).toBe(3);
  expect(everyFrames(after(new RedrawBudget(), 600, 90))).toBe(3);
});

test("a frame that comes a little early is not let go by", () => {
  expect(after(new RedrawBudget(), 600, 5).period_ms).toBeLessThan(2 * FRAME_MS - 3);
  expect(after(new RedrawBudget(), 600, 9).period_ms).toBeLessThan(3 * FRAME_MS - 3);
});

test("one slow frame changes nothing", () => {
  const budget = after(new RedrawBudget(), 600, 2);
  budget.observe(12);
  expect(budget.period_ms).toBe(0);
});

test("a little less than what made it slow does not make it fast, so that it does not go to and fro", () => {
  expect(everyFrames(after(after(new RedrawBudget(), 600, 9), 600, 6))).toBe(3);
  expect(everyFrames(after(after(new RedrawBudget(), 600, 5), 600, 2.5))).toBe(2);
  expect(everyFrames(after(new RedrawBudget(), 600, 2.5))).toBe(1);
});

test("when frames become cheap again it goes back to every one", () => {
  expect(after(after(new RedrawBudget(), 600, 9), 600, 1.5).period_ms).toBe(0);
});
