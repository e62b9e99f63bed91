import { describe, expect, test } from "vitest";
import { boxOf, overlaps, tileBox } from "./geometry";

const box = { west_deg: 2, south_deg: 1, east_deg: 6, north_deg: 3 };

describe("a tile", () => {
  test("of level 0 is one hemisphere, west first", () => {
    expect(tileBox(0, 0, 0)).toEqual({ west_deg: -180, south_deg: -90, east_deg: 0, north_deg: 90 });
    expect(tileBox(0, 1, 0)).toEqual({ west_deg: 0, south_deg: -90, east_deg: 180, north_deg: 90 });
  });

  test("is divided into four on the next level, counted from the north", () => {
    expect(tileBox(1, 1, 0)).toEqual({ west_deg: -90, south_deg: 0, east_deg: 0, north_deg: 90 });
    expect(tileBox(1, 1, 1)).toEqual({ west_deg: -90, south_deg: -90, east_deg: 0, north_deg: 0 });
  });
});

test("boxes that only touch overlap, those apart do not", () => {
  expect(overlaps(box, { ...box, west_deg: 6, east_deg: 7 })).toBe(true);
  expect(overlaps(box, { ...box, west_deg: 6.1, east_deg: 7 })).toBe(false);
  expect(overlaps(box, { ...box, south_deg: 3.1, north_deg: 4 })).toBe(false);
});

test("the box of points holds them all", () => {
  const points = [
    [4, 1],
    [-2, 3],
    [0, -5],
  ] as const;
  expect(boxOf(points)).toEqual({ west_deg: -2, east_deg: 4, south_deg: -5, north_deg: 3 });
});
