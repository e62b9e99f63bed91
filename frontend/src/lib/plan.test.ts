import { describe, expect, test } from "vitest";
import { bearing_deg, distance_m } from "./geodesy";
import {
  captureRadius_m,
  changed,
  inserted,
  legsOf,
  moved,
  placed,
  pushed,
  removed,
  samePlan,
  sameRow,
  unsentOf,
  type Waypoint,
} from "./plan";

function waypoint(latitude_deg: number, longitude_deg: number, altitude_ft = 1000, speed_kt = 55): Waypoint {
  return { latitude_deg, longitude_deg, altitude_ft, speed_kt };
}

const first = waypoint(27.9515, -15.3741, 700);
const second = waypoint(27.9503, -15.3573, 1000);
const third = waypoint(27.9239, -15.3707, 1000, 60);
const plan = [first, second, third];

describe("a leg", () => {
  test("has the great circle's distance and bearing, and its climb", () => {
    const legs = legsOf(plan);
    expect(legs).toHaveLength(2);
    expect(legs[0]?.distance_m).toBeCloseTo(1655.55, 1);
    expect(legs[0]?.bearing_deg).toBeCloseTo(94.62, 1);
    expect(legs[0]?.climb_ft).toBe(300);
    expect(legs[0]?.climb_deg).toBeCloseTo(3.16, 2);
    expect(legs[1]?.climb_deg).toBe(0);
  });

  test("that goes down is negative", () => {
    expect(legsOf([second, first])[0]?.climb_deg).toBeCloseTo(-3.16, 2);
  });

  test("is not there in a plan of one point or none", () => {
    expect(legsOf([first])).toEqual([]);
    expect(legsOf([])).toEqual([]);
  });
});

describe("the capture radius", () => {
  test.each([
    [0, 200],
    [55, 212],
    [54.999, 200],
    [60, 252],
    [100, 701],
  ])("at %d kt", (speed_kt, radius_m) => {
    // 200 m holds up to 55 kt; a hair above the formula gives 212.
    expect(captureRadius_m(speed_kt + 1e-9)).toBeCloseTo(radius_m, 0);
  });

  test("of what is no speed is the least", () => {
    expect(captureRadius_m(Number.NaN)).toBe(200);
  });
});

describe("a new point", () => {
  test("between two lies half way, at the mean altitude, and is flown to as the next is", () => {
    const [, added] = inserted([first, third], 0);
    expect(added).toMatchObject({ altitude_ft: 850, speed_kt: 60 });
    const half = distance_m(first, third) / 2;
    expect(distance_m(first, added ?? first)).toBeCloseTo(half, 0);
    expect(distance_m(added ?? first, third)).toBeCloseTo(half, 0);
  });

  test("behind the last lies a kilometre straight on", () => {
    const longer = inserted(plan, 2);
    const added = longer[3] ?? first;
    expect(distance_m(third, added)).toBeCloseTo(1000, 0);
    expect(bearing_deg(third, added)).toBeCloseTo(bearing_deg(second, third) ?? Number.NaN, 2);
    expect(added.speed_kt).toBe(60);
  });

  test("before the first lies a kilometre south of it", () => {
    const longer = inserted(plan, -1);
    expect(longer).toHaveLength(4);
    expect(bearing_deg(longer[0] ?? second, first)).toBeCloseTo(0, 2);
    expect(longer[1]).toBe(first);
  });

  test("can begin a plan, and follow its only point", () => {
    const one = inserted([], -1);
    expect(one).toHaveLength(1);
    expect(inserted(one, 0)).toHaveLength(2);
  });

  test("is written in figures that people write", () => {
    const [, added] = inserted([first, third], 0);
    expect(String(added?.latitude_deg)).toMatch(/^-?\d+\.\d{1,6}$/);
  });
});

describe("an edit", () => {
  test("moves a point up or down and keeps the others", () => {
    expect(moved(plan, 0, 1)).toEqual([second, first, third]);
    expect(moved(plan, 2, -1)).toEqual([first, third, second]);
  });

  test("beyond an end changes nothing", () => {
    expect(moved(plan, 0, -1)).toBe(plan);
    expect(moved(plan, 2, 1)).toBe(plan);
  });

  test("takes one point out", () => {
    expect(removed(plan, 1)).toEqual([first, third]);
  });

  test("to the same value is none", () => {
    expect(changed(plan, 1, "altitude_ft", 1000)).toBe(plan);
    expect(changed(plan, 9, "altitude_ft", 1)).toBe(plan);
    expect(changed(plan, 1, "altitude_ft", 900)[1]).toEqual({ ...second, altitude_ft: 900 });
  });
});

describe("a push", () => {
  test.each([
    ["north", { north_m: 100 }, 0],
    ["east", { east_m: 100 }, 90],
    ["south-west", { north_m: -100, east_m: -100 }, 225],
  ])("to the %s goes that way on the ground and keeps the height", (_, push, bearing) => {
    const after = pushed(plan, 1, push)[1] ?? first;
    const away_m = Math.hypot(...Object.values(push));
    // Positions are put down to 0.1 m.
    expect(distance_m(second, after)).toBeCloseTo(away_m, 0);
    expect(Math.abs((bearing_deg(second, after) ?? 0) - bearing)).toBeLessThan(0.1);
    expect(after.altitude_ft).toBe(second.altitude_ft);
  });

  test("upwards leaves the place as it was given, to its last figure", () => {
    const exact = [waypoint(27.95151234567, -15.3741, 700.25)];
    expect(pushed(exact, 0, { up_ft: 10 })).toEqual([{ ...exact[0], altitude_ft: 710 }]);
    expect(pushed(exact, 0, { north_m: 5 })[0]?.altitude_ft).toBe(700.25);
  });

  test("of no point is none", () => {
    expect(pushed(plan, 3, { up_ft: 10 })).toBe(plan);
    expect(placed(plan, -1, third)).toBe(plan);
  });
});

test("a point that is put somewhere keeps its speed, the others stay", () => {
  const to = { latitude_deg: 27.93456789, longitude_deg: -15.4, altitude_ft: 1234.4 };
  expect(placed(plan, 2, to)).toEqual([first, second, waypoint(27.934568, -15.4, 1234, 60)]);
});

test("what the board does not have as it is here is unsent; of an unknown plan all of it", () => {
  expect(unsentOf(plan, plan)).toEqual([false, false, false]);
  expect(unsentOf([first, { ...second, speed_kt: 56 }, third], [first, second])).toEqual([false, true, true]);
  expect(unsentOf(plan, null)).toEqual([true, true, true]);
});

describe("the waypoint flown to is found again in an edited plan", () => {
  test("in its old place", () => {
    expect(sameRow([first, second, { ...third, speed_kt: 56 }], plan, 1)).toBe(1);
  });

  test("where points before it came or went", () => {
    expect(sameRow([first, waypoint(27.5, -15.5), second, third], plan, 1)).toBe(2);
    expect(sameRow([second, third], plan, 1)).toBe(0);
  });

  test("by its number where it was changed itself, or the board's plan is not known", () => {
    expect(sameRow([first, { ...second, altitude_ft: 1300 }, third], plan, 1)).toBe(1);
    expect(sameRow(plan, null, 2)).toBe(2);
  });

  test("nearest to its old place where it stands twice", () => {
    expect(sameRow([second, first, third, second], [first, third, second], 2)).toBe(3);
  });

  test("or not at all where the plan ends before it", () => {
    expect(sameRow([first], plan, 2)).toBeNull();
  });
});

describe("two plans are the same", () => {
  test("when the board would keep the same numbers", () => {
    const sent = [waypoint(27.95, -15.37, 1000.1, 55.3)];
    const kept = [waypoint(27.95, -15.37, Math.fround(1000.1), Math.fround(55.3))];
    expect(samePlan(sent, kept)).toBe(true);
  });

  test.each([
    ["another position", [waypoint(27.9500000001, -15.37)]],
    ["another altitude", [waypoint(27.95, -15.37, 1001)]],
    ["another speed", [waypoint(27.95, -15.37, 1000, 56)]],
    ["one point more", [waypoint(27.95, -15.37), first]],
    ["no point", []],
  ])("and are not with %s", (_, other) => {
    expect(samePlan([waypoint(27.95, -15.37)], other)).toBe(false);
  });
});
