import { describe, expect, test } from "vitest";
import { bearing_deg, destination, distance_m } from "./geodesy";
import { turnRadius_m, type Waypoint } from "./plan";
import { turnAt } from "./turn";
import { wrap180 } from "./units";

const AT: Waypoint = { latitude_deg: 27.92, longitude_deg: -15.36, altitude_ft: 1000, speed_kt: 60 };
const BANK_DEG = 30;
const RADIUS_M = turnRadius_m(AT.speed_kt, BANK_DEG);

/** A turn from the north to this course. */
function turnTo(course_deg: number, leg_m = 3000) {
  const turn = turnAt(destination(AT, 180, leg_m), AT, destination(AT, course_deg, 3000), BANK_DEG);
  if (turn === null) throw new Error("no turn");
  return turn;
}

describe("a turn of the line law", () => {
  test.each([30, 90, -90, 110])("of %s° begins on one leg and ends on the next, on one circle", (course) => {
    const { arc } = turnTo(course);
    const [first, last] = [arc[0] ?? AT, arc.at(-1) ?? AT];
    const lead = RADIUS_M * Math.tan((Math.abs(course) * Math.PI) / 360);
    expect(distance_m(first, AT)).toBeCloseTo(lead, 0);
    expect(wrap180(bearing_deg(first, AT) ?? Number.NaN)).toBeCloseTo(0, 0);
    expect(distance_m(last, AT)).toBeCloseTo(lead, 0);
    expect(bearing_deg(AT, last)).toBeCloseTo((course + 360) % 360, 0);
  });

  test("that is sharp is led by one radius, and swings beyond the next leg", () => {
    const { arc } = turnTo(170);
    expect(distance_m(arc[0] ?? AT, AT)).toBeCloseTo(RADIUS_M, 0);
  });

  test("does not begin before its leg", () => {
    expect(distance_m(turnTo(90, 40).arc[0] ?? AT, AT)).toBeCloseTo(40, 0);
  });

  test("that is none has no arc; its waypoint counts across the leg", () => {
    const { arc, capture } = turnTo(1);
    expect(arc).toEqual([]);
    expect(bearing_deg(...capture)).toBeCloseTo(90.5, 0);
    expect(distance_m(...capture)).toBeCloseTo(2 * RADIUS_M, 0);
  });

  test("counts halfway through it", () => {
    expect(bearing_deg(...turnTo(90).capture)).toBeCloseTo(135, 0);
  });

  test("at the last waypoint is none", () => {
    expect(turnAt(destination(AT, 180, 3000), AT, null, BANK_DEG)?.arc).toEqual([]);
    expect(turnAt(AT, AT, null, BANK_DEG)).toBeNull();
  });
});
