import { describe, expect, test } from "vitest";
import { BLOCK_POINTS, DEGREES_PER_UNIT } from "./block";
import { TrackPoints } from "./trackPoints";

const METRES_PER_UNIT_NORTH = DEGREES_PER_UNIT * 111_195;

/** A flight north from Gando at 50 Hz, rounded as the wire rounds. */
function north(points: TrackPoints, count: number, { speed_mps = 30, climb_mps = 2, from = 0 } = {}): void {
  for (let index = from; index < from + count; index += 1) {
    const t_s = 1000 + index * 0.02;
    points.add({
      t_s,
      latitude_e7: Math.round(279_300_000 + (speed_mps * index * 0.02) / METRES_PER_UNIT_NORTH),
      longitude_e7: -153_800_000,
      altitude_mm: Math.round(100_000 + climb_mps * index * 20),
    });
  }
}

function all(points: TrackPoints, of: "t_s" | "speed_mps" | "climb_mps"): number[] {
  return points.blocks.flatMap((block) => [...block[of].subarray(0, block.count)]);
}

test("every point is kept in its order", () => {
  const points = new TrackPoints();
  north(points, 3000);
  expect(points.count).toBe(3000);
  expect(points.blocks.map(({ count }) => count)).toEqual([BLOCK_POINTS, BLOCK_POINTS, 952]);
  expect(all(points, "t_s")).toEqual(Array.from({ length: 3000 }, (_, index) => 1000 + index * 0.02));
  expect([points.first_s, points.last_s]).toEqual([1000, 1000 + 2999 * 0.02]);
});

test("steps of 1e-7 degrees at 50 Hz do not colour a steady flight", () => {
  const points = new TrackPoints();
  north(points, 2000);
  const known = all(points, "speed_mps").slice(100);
  expect(Math.min(...known)).toBeGreaterThan(29.95);
  expect(Math.max(...known)).toBeLessThan(30.05);
  const climb = all(points, "climb_mps").slice(100);
  expect(Math.max(...climb.map((value) => Math.abs(value - 2)))).toBeLessThan(0.01);
});

test("a receiver of 1 Hz has a speed from its second point on", () => {
  const points = new TrackPoints();
  for (let index = 0; index < 5; index += 1) {
    points.add({ t_s: index, latitude_e7: 279_300_000 + index * 2698, longitude_e7: 0, altitude_mm: 0 });
  }
  const [first, ...others] = all(points, "speed_mps");
  expect(first).toBeNaN();
  for (const speed of others) {
    expect(speed).toBeCloseTo(30, 1);
  }
});

describe("a new piece begins", () => {
  const point = { t_s: 1000, latitude_e7: 279_300_000, longitude_e7: -153_800_000, altitude_mm: 0 };

  test.each([
    ["after more than ten seconds", { ...point, t_s: 1010.5 }, true],
    ["not before that", { ...point, t_s: 1009.5 }, false],
    ["at a jump that no aircraft flies", { ...point, t_s: 1000.02, latitude_e7: 279_320_000 }, true],
    ["not across the date line", { ...point, t_s: 1000.02, longitude_e7: -153_800_100 }, false],
    ["when the clock was set back", { ...point, t_s: 999 }, true],
  ])("%s", (_, next, begins) => {
    const points = new TrackPoints();
    points.add(point);
    points.add(next);
    expect(points.blocks[0]?.starts).toEqual(begins ? [0, 1] : [0]);
  });

  test("and its speed knows nothing of the one before", () => {
    const points = new TrackPoints();
    north(points, 200);
    points.add({ ...point, t_s: 2000 });
    points.add({ ...point, t_s: 2002 });
    expect(all(points, "speed_mps").slice(-2)).toEqual([Number.NaN, 0]);
  });

  test("and the short way round is taken where the date changes", () => {
    const points = new TrackPoints();
    points.add({ ...point, longitude_e7: 1_799_999_990 });
    points.add({ ...point, t_s: 1001, longitude_e7: -1_799_999_990 });
    expect(points.blocks[0]?.starts).toEqual([0]);
  });
});

test("memory is bounded: the newest half keeps every point, the oldest are thinned, both ends stay", () => {
  const points = new TrackPoints(8);
  north(points, 40 * BLOCK_POINTS);
  expect(points.blocks.length).toBeLessThanOrEqual(8);
  expect(points.count).toBe(points.blocks.reduce((sum, { count }) => sum + count, 0));
  const times = all(points, "t_s");
  expect(times).toEqual([...times].sort((one, other) => one - other));
  expect(times[0]).toBe(1000);
  const newest = times.slice(-4 * BLOCK_POINTS);
  expect(newest.at(-1)).toBe(points.last_s);
  expect(Math.max(...newest.slice(1).map((t_s, at) => t_s - (newest[at] ?? 0)))).toBeLessThan(0.021);
  expect(all(points, "speed_mps").at(-1)).toBeCloseTo(30, 1);
});

test("what is cleared is gone, and the next point begins a piece", () => {
  const points = new TrackPoints();
  north(points, 100);
  const { revision } = points;
  points.clear();
  expect([points.count, points.first_s, points.last_s, points.altitude_m]).toEqual([0, null, null, null]);
  expect(points.revision).not.toBe(revision);
  north(points, 1);
  expect(points.blocks[0]?.starts).toEqual([0]);
});

test("the spread of heights, speeds and climbs is known", () => {
  const points = new TrackPoints();
  north(points, 500);
  expect(points.altitude_m?.least).toBe(100);
  expect(points.altitude_m?.most).toBeCloseTo(100 + 2 * 499 * 0.02, 2);
  expect(points.speed_mps?.most).toBeCloseTo(30, 1);
  expect(points.climb_mps?.least).toBeCloseTo(2, 1);
});
