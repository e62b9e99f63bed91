import { describe, expect, test } from "vitest";
import {
  boxOf,
  clipFilled,
  linesNear,
  metresOfDegree,
  overlaps,
  type Point,
  type Ring,
  thinned,
  tileBox,
} from "./geometry";

const square: Ring = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];
const box = { west_deg: 2, south_deg: 1, east_deg: 6, north_deg: 3 };

/** Area of a ring, counter-clockwise positive. */
function area(ring: Ring): number {
  return (
    ring.reduce((sum, [x, y], index) => {
      const [nextX, nextY] = ring[(index + 1) % ring.length] ?? [x, y];
      return sum + x * nextY - nextX * y;
    }, 0) / 2
  );
}

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

describe("a filled ring", () => {
  test("keeps just what lies in the box", () => {
    const clipped = clipFilled(square, box);
    expect(area(clipped)).toBeCloseTo(4);
    expect(boxOf(clipped)).toEqual({ west_deg: 2, south_deg: 1, east_deg: 4, north_deg: 3 });
  });

  test("around the box fills it whole, and beside it leaves nothing", () => {
    expect(area(clipFilled(square, { west_deg: 1, south_deg: 1, east_deg: 2, north_deg: 2 }))).toBeCloseTo(1);
    expect(clipFilled(square, { west_deg: 5, south_deg: 5, east_deg: 6, north_deg: 6 })).toEqual([]);
  });

  test("with a bay keeps the bay", () => {
    const bay: Ring = [
      [0, 0],
      [4, 0],
      [4, 4],
      [2, 2],
      [0, 4],
    ];
    expect(area(clipFilled(bay, { west_deg: 0, south_deg: 2, east_deg: 4, north_deg: 4 }))).toBeCloseTo(4);
  });
});

describe("the coast of a ring", () => {
  test("is taken with its neighbours outside, and without the box's own edges", () => {
    const lines = linesNear(square, box);
    expect(lines).toEqual([
      [
        [4, 0],
        [4, 4],
      ],
    ]);
  });

  test("crosses a box in which it has no point", () => {
    const thin = { west_deg: 3, south_deg: 1, east_deg: 5, north_deg: 1.5 };
    expect(linesNear(square, thin)).toEqual([
      [
        [4, 0],
        [4, 4],
      ],
    ]);
  });

  test("comes in as many lines as it enters", () => {
    const across = { west_deg: -1, south_deg: 1, east_deg: 5, north_deg: 2 };
    expect(linesNear(square, across)).toHaveLength(2);
  });
});

test("a thinned ring keeps its first point and every one that is far enough from the last kept", () => {
  const line: Point[] = [
    [0, 0],
    [0.4, 0],
    [0.9, 0],
    [1.1, 0],
    [2.5, 0],
  ];
  expect(thinned(line, 1)).toEqual([
    [0, 0],
    [1.1, 0],
    [2.5, 0],
  ]);
});

test("boxes that only touch overlap, those apart do not", () => {
  expect(overlaps(box, { ...box, west_deg: 6, east_deg: 7 })).toBe(true);
  expect(overlaps(box, { ...box, west_deg: 6.1, east_deg: 7 })).toBe(false);
  expect(overlaps(box, { ...box, south_deg: 3.1, north_deg: 4 })).toBe(false);
});

test("a degree is as long as on the ellipsoid", () => {
  // Tables of the WGS 84 ellipsoid.
  expect(metresOfDegree(0).longitude_m).toBeCloseTo(111_319.5, -1);
  expect(metresOfDegree(0).latitude_m).toBeCloseTo(110_574.3, -1);
  expect(metresOfDegree(45).longitude_m).toBeCloseTo(78_846.8, -1);
  expect(metresOfDegree(45).latitude_m).toBeCloseTo(111_131.8, -1);
});
