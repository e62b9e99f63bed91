import { expect, test } from "vitest";
import { wrap360 } from "./angles";

test.each([
  [0, 0],
  [360, 0],
  [-0, 0],
  [-90, 270],
  [-180, 180],
  [725, 5],
  [-1e-15, 0],
  [359.9996, 359.9996],
])("%d degrees is heading %d", (angle_deg, heading_deg) => {
  expect(wrap360(angle_deg)).toBe(heading_deg);
});

test("a heading is never 360 nor negative", () => {
  for (let angle_deg = -1000; angle_deg <= 1000; angle_deg += 0.37) {
    const heading_deg = wrap360(angle_deg);
    expect(heading_deg).toBeGreaterThanOrEqual(0);
    expect(heading_deg).toBeLessThan(360);
  }
});
