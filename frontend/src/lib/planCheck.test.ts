import { describe, expect, test } from "vitest";
import { ROUTES } from "../protocol/messages.gen";
import { PLAN_LIMITS } from "../protocol/missions";
import { destination } from "./geodesy";
import type { Waypoint } from "./plan";
import { checkPlan } from "./planCheck";

const start: Waypoint = { latitude_deg: 27.9319, longitude_deg: -15.3866, altitude_ft: 1000, speed_kt: 55 };

/** A point this far east of the start. */
function east(distance: number, parts: Partial<Waypoint> = {}): Waypoint {
  return { ...start, ...destination(start, 90, distance), ...parts };
}

function codes(...waypoints: Waypoint[]): string[] {
  return checkPlan(waypoints, PLAN_LIMITS).map(
    ({ level, code, row, field }) => `${level} ${code} ${row} ${field}`,
  );
}

test.each(ROUTES)("the built-in route $title has nothing wrong", ({ waypoints }) => {
  expect(checkPlan(waypoints, PLAN_LIMITS)).toEqual([]);
});

describe("a plan", () => {
  test("without points, or with more than a hundred, cannot be sent", () => {
    expect(codes()).toEqual(["error count null null"]);
    const many = Array.from({ length: 101 }, (_, index) => east(1000 * index));
    expect(codes(...many)).toEqual(["error count null null"]);
    expect(codes(...many.slice(1))).toEqual([]);
  });

  test.each([
    ["latitude_deg", 90.001],
    ["latitude_deg", -90.001],
    ["longitude_deg", 180.5],
    ["altitude_ft", -2001],
    ["altitude_ft", 60001],
    ["speed_kt", -1],
    ["speed_kt", 501],
    ["speed_kt", Number.NaN],
  ] as const)("with a %s of %d cannot be sent, and the cell is told", (field, value) => {
    expect(codes({ ...start, [field]: value })).toEqual([`error range 0 ${field}`]);
  });

  test("does not judge the way to a point that is no place", () => {
    expect(codes(start, { ...start, latitude_deg: 200 }, east(2000))).toEqual(["error range 1 latitude_deg"]);
  });

  test("with the same place twice in a row cannot be sent; a circuit may end where it began", () => {
    expect(codes(start, { ...start, altitude_ft: 1100 })).toEqual(["error same_place 1 latitude_deg"]);
    expect(codes(start, east(2000), start)).toEqual([]);
  });
});

describe("a climb", () => {
  const feet = (angle_deg: number, over_m: number): number =>
    1000 + (over_m * Math.tan((angle_deg * Math.PI) / 180)) / 0.3048;

  test.each([
    [7.9, []],
    [8.1, ["warning steep 1 altitude_ft"]],
    [14.9, ["warning steep 1 altitude_ft"]],
    [15.1, ["error too_steep 1 altitude_ft"]],
    [-7.9, []],
    [-19.9, ["warning steep 1 altitude_ft"]],
    [-20.1, ["error too_steep 1 altitude_ft"]],
  ])("of %d degrees", (angle_deg, found) => {
    expect(codes(start, east(1500, { altitude_ft: feet(angle_deg, 1500) }))).toEqual(found);
  });
});

describe("a warning does not prevent the upload:", () => {
  test.each([
    ["a point within the capture circle of the next", east(199), "inside_capture"],
    ["a leg of more than fifty kilometres", east(50_001), "far"],
    ["a speed at which the autopilot holds still", east(2000, { speed_kt: 19 }), "slow"],
  ])("%s", (_, second, code) => {
    const issues = checkPlan([start, second], PLAN_LIMITS);
    expect(issues.map(({ level, code }) => [level, code])).toEqual([["warning", code]]);
  });

  test("the faster, the larger the circle", () => {
    expect(codes(start, east(400))).toEqual([]);
    expect(codes(start, east(400, { speed_kt: 100 }))).toEqual(["warning inside_capture 1 latitude_deg"]);
  });
});
