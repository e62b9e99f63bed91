import { expect, test } from "vitest";
import { coordinate, degreesPerSecond, heading, hundredths, tenths, thousandths, whole } from "./formats";

test("no format makes text of no data or of what is no number", () => {
  for (const format of [whole, tenths, hundredths, thousandths, coordinate, heading, degreesPerSecond]) {
    expect(format(null)).toBeNull();
    expect(format(Number.NaN)).toBeNull();
  }
});

test("a rate of turn is told in degrees a second", () => {
  expect(degreesPerSecond(-Math.PI / 180)).toBe("-1.0");
});

test("a coordinate keeps the tenth of a metre", () => {
  expect(coordinate(-15.392912)).toBe("-15.392912");
});
