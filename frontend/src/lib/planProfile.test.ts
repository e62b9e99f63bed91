import { describe, expect, test } from "vitest";
import { destination } from "./geodesy";
import { legsOf, type Waypoint } from "./plan";
import { clearanceOf, profilePlaces } from "./planProfile";

const start: Waypoint = { latitude_deg: 27.93, longitude_deg: -15.39, altitude_ft: 700, speed_kt: 55 };
const plan: readonly Waypoint[] = [
  start,
  { ...start, ...destination(start, 40, 5000), altitude_ft: 1700 },
  { ...start, ...destination(start, 100, 9000), altitude_ft: 1200 },
];

describe("the places along a plan", () => {
  test("hold each waypoint, are no farther apart than wanted, and end where the plan does", () => {
    const places = profilePlaces(plan, 200, 1000);
    const total_m = legsOf(plan).reduce((sum, { distance_m }) => sum + distance_m, 0);
    expect(places.at(-1)?.along_m).toBeCloseTo(total_m, 6);
    for (const waypoint of plan) {
      expect(places.some((place) => place.latitude_deg === waypoint.latitude_deg)).toBe(true);
    }
    for (const [index, { along_m }] of places.slice(1).entries()) {
      const apart_m = along_m - (places[index]?.along_m ?? 0);
      expect(apart_m).toBeGreaterThan(0);
      expect(apart_m).toBeLessThanOrEqual(200);
    }
  });

  test("are never more than wanted, however long the plan is", () => {
    expect(profilePlaces(plan, 1, 300).length).toBeLessThanOrEqual(300 + plan.length);
    expect(profilePlaces([], 200, 300)).toEqual([]);
    expect(profilePlaces([start], 200, 300)).toHaveLength(1);
  });

  test("climb evenly from one waypoint to the next", () => {
    for (const { along_m, altitude_ft, row } of profilePlaces(plan, 100, 1000)) {
      const expected = 700 + (along_m / 5000) * 1000;
      expect(row > 1 || Math.abs(altitude_ft - expected) < 0.1).toBe(true);
    }
  });
});

describe("the clearance", () => {
  const places = profilePlaces(plan, 250, 1000);

  test("is the least over the known ground, and names the legs that are too low", () => {
    const heights = places.map(({ row }) => (row === 2 ? 300 : 0));
    const { least, low, unknown } = clearanceOf(places, heights, 300);
    expect(unknown).toBe(0);
    expect(least?.row).toBe(2);
    expect(least?.clearance_ft).toBeCloseTo(1200 - 300 / 0.3048, 6);
    expect(low.map(({ row }) => row)).toEqual([2]);
  });

  test("of unknown ground is not known, and never a clearance over the sea", () => {
    const none = clearanceOf(
      places,
      places.map(() => null),
      300,
    );
    expect(none).toEqual({ least: null, unknown: 1, low: [] });
    const half = clearanceOf(
      places,
      places.map(({ row }) => (row === 2 ? null : 0)),
      300,
    );
    expect(half.unknown).toBeGreaterThan(0.3);
    expect(half.least?.row).toBe(0);
  });
});
