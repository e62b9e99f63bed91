import { describe, expect, test } from "vitest";
import { digitsPath } from "../dial/digits";
import {
  BALL_RADIUS,
  horizonShift,
  isAttitude,
  LADDER_BANDS,
  ladderShift,
  RUNGS,
  rollTurn_deg,
  UNITS_PER_DEGREE,
} from "./geometry";

describe("the horizon", () => {
  test("lies level through the middle in level flight", () => {
    expect(rollTurn_deg(0)).toBe(0);
    expect(rollTurn_deg(-0)).toBe(0);
    expect(horizonShift(0)).toBe(0);
    expect(ladderShift(0)).toBe(0);
  });

  test("turns left in a bank to the right", () => {
    // The page turns clockwise: 330 is thirty degrees to the left.
    expect(rollTurn_deg(30)).toBe(330);
    expect(rollTurn_deg(-30)).toBe(30);
  });

  test("moves down when the nose goes up, and up when it goes down", () => {
    expect(horizonShift(10)).toBe(10 * UNITS_PER_DEGREE);
    expect(horizonShift(-10)).toBe(-10 * UNITS_PER_DEGREE);
  });

  test.each([90, 60, -60, -90, 400, -400])(
    "never leaves the ball, at %d degrees of pitch neither",
    (pitch_deg) => {
      const shift = horizonShift(pitch_deg);
      expect(Math.abs(shift)).toBeLessThan(BALL_RADIUS);
      expect(Math.sign(shift)).toBe(Math.sign(pitch_deg));
    },
  );

  test("comes round whole over the back and is the same from either side", () => {
    expect(rollTurn_deg(180)).toBe(rollTurn_deg(-180));
    expect(rollTurn_deg(540)).toBe(180);
  });
});

describe("the pitch ladder", () => {
  test("brings the rung of the present pitch to the middle", () => {
    for (const { pitch_deg, y } of RUNGS) {
      expect(y + ladderShift(pitch_deg)).toBeCloseTo(0, 6);
    }
  });

  test("stops at straight up and straight down", () => {
    expect(ladderShift(120)).toBe(ladderShift(90));
    expect(ladderShift(-120)).toBe(ladderShift(-90));
  });

  test("draws every rung once, in bands of ten degrees", () => {
    const lines = LADDER_BANDS.flatMap(({ path }) => path.match(/M-?[\d.]+ -?[\d.]+H/g) ?? []);
    expect(lines).toHaveLength(RUNGS.length);
    expect(new Set(lines).size).toBe(RUNGS.length);
  });

  test("numbers each ten degrees on both sides, and nothing between", () => {
    const ten = LADDER_BANDS.find(({ from_deg }) => from_deg === 10)?.path ?? "";
    const y = -10 * UNITS_PER_DEGREE;
    expect(ten).toContain(digitsPath(10, -33, y, 6.4));
    expect(ten).toContain(digitsPath(10, 33, y, 6.4));
    const numbered = RUNGS.filter(({ halfWidth }) => halfWidth === 24).map(({ pitch_deg }) => pitch_deg);
    expect(numbered).toEqual([
      -90, -80, -70, -60, -50, -40, -30, -20, -10, 10, 20, 30, 40, 50, 60, 70, 80, 90,
    ]);
  });
});

test("half an attitude is none, and so is a value that is no number", () => {
  expect(isAttitude({ pitch_deg: 0, roll_deg: 0 })).toBe(true);
  expect(isAttitude(null)).toBe(false);
  expect(isAttitude({ pitch_deg: null, roll_deg: 3 })).toBe(false);
  expect(isAttitude({ pitch_deg: 3, roll_deg: Number.NaN })).toBe(false);
  expect(isAttitude({ pitch_deg: Number.POSITIVE_INFINITY, roll_deg: 0 })).toBe(false);
});
