import { describe, expect, test } from "vitest";
import { bearing_deg, distance_m } from "../../lib/geodesy";
import { awayFromLine, heightAlongVertical, legPoints, nearest, ring, throughLevel } from "./geometry";

const gando = { latitude_deg: 27.9319, longitude_deg: -15.3866 };
const enu = (east_m: number, north_m: number, up_m: number) => ({ east_m, north_m, up_m });

describe("a line of sight", () => {
  test("from above meets a level where it points to", () => {
    const sight = { origin: enu(0, -1000, 1000), direction: enu(0, 1, -1) };
    expect(throughLevel(sight, 0)).toEqual(enu(0, 0, 0));
    expect(throughLevel(sight, 300)).toEqual(enu(0, -300, 300));
  });

  test("from below meets a level above it", () => {
    const sight = { origin: enu(100, 0, 0), direction: enu(0, 3, 4) };
    expect(throughLevel(sight, 400)).toEqual(enu(100, 300, 400));
  });

  test.each([
    ["away from the level", enu(0, 1, 1)],
    ["along it", enu(0, 1, 0)],
    ["nearly along it, to the horizon", enu(0, 1, -0.004)],
  ])("that goes %s has no point of it", (_, direction) => {
    expect(throughLevel({ origin: enu(0, 0, 2000), direction }, 0)).toBeNull();
  });

  test("tells the height at which it passes a vertical", () => {
    const sight = { origin: enu(0, -1000, 500), direction: enu(0, 10, 1) };
    expect(heightAlongVertical(sight)).toBeCloseTo(600);
    // Beside it the nearest point counts.
    expect(heightAlongVertical({ ...sight, origin: enu(40, -1000, 500) })).toBeCloseTo(600);
  });

  test("tells no height straight down, or behind the eye", () => {
    expect(heightAlongVertical({ origin: enu(0, 0, 900), direction: enu(0, 0, -1) })).toBeNull();
    expect(heightAlongVertical({ origin: enu(0, 500, 900), direction: enu(0, 1, 0) })).toBeNull();
  });
});

test("a ring is closed, and everywhere as far from its middle as the capture radius", () => {
  const places = ring(gando, 317, 48);
  expect(places).toHaveLength(49);
  expect(places.at(-1)).toEqual(places[0]);
  for (const place of places) {
    expect(distance_m(gando, place)).toBeCloseTo(317, 3);
  }
  expect(bearing_deg(gando, places[12] ?? gando)).toBeCloseTo(90, 3);
});

describe("a leg", () => {
  test("of a circuit is one line", () => {
    const from = { ...gando, altitude_ft: 250 };
    const to = { latitude_deg: 27.95, longitude_deg: -15.37, altitude_ft: 700 };
    expect(legPoints(from, to)).toEqual([from, to]);
  });

  test("over the sea follows the great circle and climbs evenly", () => {
    const from = { latitude_deg: 28, longitude_deg: -16, altitude_ft: 1000 };
    const to = { latitude_deg: 28, longitude_deg: -15, altitude_ft: 2000 };
    const points = legPoints(from, to);
    expect(points).toHaveLength(6);
    const lengths = points.slice(1).map((point, index) => distance_m(points[index] ?? point, point));
    for (const length of lengths) {
      expect(length).toBeCloseTo(distance_m(from, to) / 5, 3);
    }
    expect(points.map(({ altitude_ft }) => altitude_ft)).toEqual([1000, 1200, 1400, 1600, 1800, 2000]);
    expect(points[2]?.latitude_deg).toBeGreaterThan(28);
  });
});

describe("under the pointer", () => {
  const spots = [{ x: 10, y: 10 }, null, { x: 16, y: 10 }];

  test("is the nearest spot within reach, and none that cannot be seen", () => {
    expect(nearest(spots, { x: 14, y: 10 }, 10)).toBe(2);
    expect(nearest(spots, { x: 11, y: 10 }, 10)).toBe(0);
    expect(nearest(spots, { x: 40, y: 40 }, 10)).toBeNull();
  });

  test("a line is as far as its nearest point", () => {
    const [from, to] = [
      { x: 0, y: 0 },
      { x: 0, y: 100 },
    ];
    expect(awayFromLine({ x: 5, y: 50 }, from, to)).toBe(5);
    expect(awayFromLine({ x: 3, y: 104 }, from, to)).toBe(5);
    expect(awayFromLine({ x: 3, y: 4 }, from, from)).toBe(5);
  });
});
