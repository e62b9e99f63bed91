import { expect, test } from "vitest";
import { writeEcef } from "../ecef";
import { DEGREES_PER_UNIT, METRES_PER_UNIT, type TrackBlock } from "./block";
import { ThinnedTrack } from "./thinnedTrack";
import { kept, type WeightedBlock } from "./thinning";
import { TrackPoints } from "./trackPoints";

/** Circles, climbs and a straight leg, with the noise of a receiver. */
function flown(count: number): TrackPoints {
  const points = new TrackPoints();
  let seed = 7;
  const noise = (): number => {
    seed = (seed * 1_103_515_245 + 12_345) % 2 ** 31;
    return seed / 2 ** 31 - 0.5;
  };
  for (let index = 0; index < count; index += 1) {
    const turn = index / 300;
    points.add({
      t_s: 1000 + index * 0.02,
      latitude_e7: Math.round(279_300_000 + 20_000 * Math.sin(turn) + index * 3 + 4 * noise()),
      longitude_e7: Math.round(-153_800_000 + 25_000 * Math.cos(turn * 1.1) + 4 * noise()),
      altitude_mm: Math.round(300_000 + 100_000 * Math.sin(turn / 3) + 50 * noise()),
    });
  }
  return points;
}

function place(block: TrackBlock, offset: number): Float64Array {
  const at = new Float64Array(3);
  writeEcef(
    at,
    0,
    (block.latitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
    (block.longitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
    (block.altitude_mm[offset] ?? 0) * METRES_PER_UNIT,
  );
  return at;
}

/** Distance of a point from a straight line between two others, computed independently of the code. */
function strays_m(a: Float64Array, b: Float64Array, p: Float64Array): number {
  let nearest = Number.POSITIVE_INFINITY;
  for (let step = 0; step <= 200; step += 1) {
    const along = step / 200;
    nearest = Math.min(
      nearest,
      Math.hypot(...[0, 1, 2].map((k) => (a[k] ?? 0) + along * ((b[k] ?? 0) - (a[k] ?? 0)) - (p[k] ?? 0))),
    );
  }
  return nearest;
}

function worst_m({ block }: WeightedBlock, offsets: readonly number[]): number {
  let worst = 0;
  for (let at = 0; at + 1 < offsets.length; at += 1) {
    const [first, last] = [offsets[at] ?? 0, offsets[at + 1] ?? 0];
    const [from, to] = [place(block, first), place(block, last)];
    for (let offset = first + 1; offset < last; offset += 7) {
      worst = Math.max(worst, strays_m(from, to, place(block, offset)));
    }
  }
  return worst;
}

function thinned(points: TrackPoints): readonly WeightedBlock[] {
  const track = new ThinnedTrack(points);
  track.refresh(() => false);
  return track.blocks;
}

test("a level strays no farther from what was flown than its tolerance, and has fewer points the coarser it is", () => {
  for (const block of thinned(flown(3 * 1024))) {
    let before = Number.POSITIVE_INFINITY;
    for (const tolerance_m of [0.1, 1, 8, 64, 512]) {
      const offsets = kept(block, tolerance_m);
      expect(worst_m(block, offsets)).toBeLessThanOrEqual(tolerance_m * 1.02);
      expect(offsets.length).toBeLessThanOrEqual(before);
      before = offsets.length;
    }
    expect(before).toBeLessThan(10);
  }
});

test("both ends of each block are in every level, so that neighbours meet at any mix of levels", () => {
  for (const block of thinned(flown(4 * 1024))) {
    for (const tolerance_m of [0, 3, 1000, 1e9]) {
      const offsets = kept(block, tolerance_m);
      expect([offsets[0], offsets.at(-1)]).toEqual([0, 1023]);
    }
  }
});

test("the ends of a piece are never thinned away", () => {
  const points = flown(500);
  for (let index = 0; index < 600; index += 1) {
    points.add({ t_s: 2000 + index, latitude_e7: index * 100, longitude_e7: 0, altitude_mm: 0 });
  }
  const [block] = thinned(points);
  expect(block && kept(block, 1e9)).toEqual([0, 499, 500, 1023]);
});

test("a change of speed on a straight leg keeps its place: what colours the line is thinned no more than its course", () => {
  const points = new TrackPoints();
  let latitude_e7 = 279_300_000;
  for (let index = 0; index < 1024; index += 1) {
    latitude_e7 += index < 500 ? 40 : 90;
    points.add({ t_s: 1000 + index * 0.02, latitude_e7, longitude_e7: 0, altitude_mm: 0 });
  }
  const [block] = thinned(points);
  const near = block ? kept(block, 20) : [];
  expect(near.some((offset) => offset > 450 && offset < 650)).toBe(true);
});

test("the ball of a block holds all its points", () => {
  for (const { block, centre, radius_m } of thinned(flown(2048))) {
    for (let offset = 0; offset < block.count; offset += 50) {
      const [x = 0, y = 0, z = 0] = place(block, offset);
      expect(Math.hypot(x - centre[0], y - centre[1], z - centre[2])).toBeLessThanOrEqual(radius_m + 0.01);
    }
  }
});

test("levels are made a few at a time, newest first and without a gap, and only once", () => {
  const points = flown(10 * 1024 + 5);
  const track = new ThinnedTrack(points);
  let left = 4;
  expect(track.refresh(() => left-- <= 0)).toBe(true);
  expect(track.blocks.map(({ block }) => block)).toEqual(points.blocks.slice(6, 10));
  expect(track.isComplete).toBe(false);
  const before = track.blocks;
  expect(track.refresh(() => false)).toBe(true);
  expect(track.blocks.map(({ block }) => block)).toEqual(points.blocks.slice(0, 10));
  expect(track.blocks.slice(6)).toEqual(before);
  expect(track.isComplete).toBe(true);
  expect(track.refresh(() => false)).toBe(false);
});

test("what was cleared has no levels", () => {
  const points = flown(2048);
  const track = new ThinnedTrack(points);
  track.refresh(() => false);
  points.clear();
  expect(track.refresh(() => false)).toBe(true);
  expect(track.blocks).toEqual([]);
});
