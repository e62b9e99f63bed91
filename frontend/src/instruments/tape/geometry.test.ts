import { expect, test } from "vitest";
import {
  ALTITUDE_TAPES,
  bugPercent,
  middleOf,
  numbersOf,
  onTape,
  SPEED_TAPES,
  shiftPercent,
  tapeOf,
} from "./geometry";

const [KNOTS] = SPEED_TAPES;
const [FEET] = ALTITUDE_TAPES;

test("each chosen unit has its tape, any other gets the usual one", () => {
  expect(SPEED_TAPES.map(({ unit }) => tapeOf(SPEED_TAPES, unit).unit)).toEqual(["kt", "kmPerH", "mPerS"]);
  expect(tapeOf(ALTITUDE_TAPES, "km")).toBe(FEET);
});

test("the value's own number stands at the index, greater ones above it", () => {
  expect(numbersOf(KNOTS, middleOf(KNOTS, 62))).toEqual([
    "100",
    "90",
    "80",
    "70",
    "60",
    "50",
    "40",
    "30",
    "20",
  ]);
  // The number 60 is drawn in the middle: at 63 kt it has gone down by 3 of the 60 that are seen.
  expect(shiftPercent(KNOTS, 63, 60)).toBe(5);
  expect(shiftPercent(KNOTS, 57, 60)).toBe(-5);
});

test("a speed below zero has no number, an altitude below the sea has", () => {
  expect(numbersOf(KNOTS, 0)).toEqual(["40", "30", "20", "10", "0", "", "", "", ""]);
  expect(numbersOf(FEET, 0)).toEqual(["300", "200", "100", "0", "-100", "-200", "-300"]);
});

test.each([
  [1000, 1000, 0],
  [1000, 1100, -25],
  [1000, 900, 25],
  [1000, 9000, -47],
  [1000, -9000, 47],
])(
  "at %d ft the target of %d ft stands %d %% below the index and never leaves the tape",
  (shown, target, at) => {
    expect(bugPercent(FEET, shown, target)).toBe(at);
  },
);

test("a value is drawn in the tape's unit, and none where there is none", () => {
  expect(onTape(tapeOf(ALTITUDE_TAPES, "m"), 1000, "ft")).toBeCloseTo(304.8, 9);
  expect([null, Number.NaN, Number.POSITIVE_INFINITY].map((none) => onTape(FEET, none, "ft"))).toEqual([
    null,
    null,
    null,
  ]);
});
