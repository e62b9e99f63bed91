import { expect, test } from "vitest";
import { roundLength } from "./scaleBar";

test.each([
  [1, 1],
  [1.99, 1],
  [4.9, 2],
  [99, 50],
  [0.3, 0.2],
  [123_456, 100_000],
])("of at most %s the round length is %s", (most, length) => {
  expect(roundLength(most)).toBeCloseTo(length, 9);
});
