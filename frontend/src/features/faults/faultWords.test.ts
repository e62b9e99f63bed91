import { expect, test } from "vitest";
import type { FaultChoice } from "../../protocol/guards.gen";
import { askedStrength, shownStrength, shownUnit } from "./faultWords";

const RATE: FaultChoice = {
  place: "gyro",
  kind: "bias",
  says: "",
  unit: "rad/s",
  usual: 0.03,
  lowest: -10,
  highest: 10,
  usual_s: null,
};

test("rates are read in degrees and shares in percent", () => {
  expect(shownStrength(0.03, "rad/s")).toBe(1.72);
  expect(shownStrength(0.5, "1")).toBe(50);
  expect(shownStrength(8, "kt")).toBe(8);
  expect(shownUnit("")).toBeNull();
});

test("what is typed goes back in the station's unit, and the rounded end of the range is the station's", () => {
  expect(askedStrength(57.2958, RATE)).toBeCloseTo(1, 5);
  expect(askedStrength(shownStrength(10, "rad/s"), RATE)).toBeLessThanOrEqual(10);
  expect(askedStrength(shownStrength(-10, "rad/s"), RATE)).toBeGreaterThanOrEqual(-10);
});
