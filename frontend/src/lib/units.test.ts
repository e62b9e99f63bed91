import { expect, test } from "vitest";
import { degreesFromRadians, feetFromMetres } from "./units";

test("a half turn is 180 degrees", () => {
  expect(degreesFromRadians(Math.PI)).toBeCloseTo(180, 12);
});

test("a foot is 0.3048 metres exactly", () => {
  expect(feetFromMetres(304.8)).toBeCloseTo(1000, 9);
});
