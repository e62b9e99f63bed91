import { expect, test } from "vitest";
import { rollDemand } from "./rollDemand";

const { compute } = rollDemand("hil", () => 0.8, { label: "" });

test.each([
  ["a course to the right asks for the right wing down", [1, 100, 5000, 50, 90], 8],
  ["over north it is the short way", [1, 350, 5000, 50, 10], -16],
  ["never more than thirty degrees", [1, 180, 5000, 50, 10], 30],
  ["without the autopilot nothing is asked for", [0, 100, 5000, 50, 90], null],
  ["nor without a plan", [1, null, null, null, 90], null],
  ["near its waypoint it may fly the circle", [1, 100, 399, 50, 90], null],
] as const)("%s", (_, operands, roll_deg) => {
  expect(compute(operands)).toEqual(roll_deg);
});

test("with an unknown gain it is not known", () => {
  expect(rollDemand("flight", () => null, { label: "" }).compute([1, 100, 5000, 50, 90])).toBeNull();
});
