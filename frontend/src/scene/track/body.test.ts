import { expect, test } from "vitest";
import { writeEcef } from "../../lib/ecef";
import { DEGREES_PER_UNIT, METRES_PER_UNIT, type TrackBlock } from "../../lib/track/block";
import { ThinnedTrack } from "../../lib/track/thinnedTrack";
import { TrackPoints } from "../../lib/track/trackPoints";
import { POINT_FLOATS, placeOf } from "../ribbon/vertices";
import { type Eye, MAX_BODY_POINTS, TrackBody } from "./body";

const STRAY_RAD = 0.0012;

/** Circuits beside Gando at 50 Hz. */
function circuits(count: number, wobble_e7 = 0): TrackPoints {
  const points = new TrackPoints();
  for (let index = 0; index < count; index += 1) {
    const turn = index / 1500;
    points.add({
      t_s: 1000 + index * 0.02,
      latitude_e7: Math.round(279_300_000 + 100_000 * Math.sin(turn) + (index % 2) * wobble_e7),
      longitude_e7: Math.round(-153_800_000 + 60_000 * Math.cos(turn)),
      altitude_mm: Math.round(300_000 + 90_000 * Math.sin(turn / 7)),
    });
  }
  return points;
}

function bodyOf(points: TrackPoints): TrackBody {
  const track = new ThinnedTrack(points);
  track.refresh(() => false);
  return new TrackBody(track);
}

function eyeAt(latitude_deg: number, longitude_deg: number, height_m: number): Eye {
  const at = new Float64Array(3);
  writeEcef(at, 0, latitude_deg, longitude_deg, height_m);
  return { x: at[0] ?? 0, y: at[1] ?? 0, z: at[2] ?? 0, stray_rad: STRAY_RAD };
}

const NEAR = eyeAt(27.93, -15.374, 320);
const FAR = eyeAt(27.93, -15.38, 60_000);

function places(body: TrackBody): number[][] {
  return Array.from({ length: body.count }, (_, at) => placeOf(body.vertices, at));
}

function flownAt(block: TrackBlock, offset: number): number[] {
  const at = new Float64Array(3);
  writeEcef(
    at,
    0,
    (block.latitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
    (block.longitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
    (block.altitude_mm[offset] ?? 0) * METRES_PER_UNIT,
  );
  return [...at];
}

function apart_m(one: readonly number[], other: readonly number[]): number {
  return Math.hypot(...[0, 1, 2].map((axis) => (one[axis] ?? 0) - (other[axis] ?? 0)));
}

/** Distance to the nearest place of a line, a tenth of a metre fine. */
function toLine_m(line: readonly number[][], point: readonly number[]): number {
  let nearest = Number.POSITIVE_INFINITY;
  for (let at = 0; at + 1 < line.length; at += 1) {
    const [from = [], to = []] = [line[at], line[at + 1]];
    const course = [0, 1, 2].map((axis) => (to[axis] ?? 0) - (from[axis] ?? 0));
    const length2 = course.reduce((sum, part) => sum + part * part, 0);
    const along = course.reduce(
      (sum, part, axis) => sum + part * ((point[axis] ?? 0) - (from[axis] ?? 0)),
      0,
    );
    const share = length2 === 0 ? 0 : Math.max(0, Math.min(1, along / length2));
    nearest = Math.min(
      nearest,
      apart_m(
        point,
        course.map((part, axis) => (from[axis] ?? 0) + share * part),
      ),
    );
  }
  return nearest;
}

test("two hours at 50 Hz are drawn from afar with hardly more points than they have blocks", () => {
  const body = bodyOf(circuits(360_000));
  body.choose(FAR);
  expect(body.blocks.length).toBe(351);
  expect(body.count).toBeLessThan(1500);
});

test.each([
  ["afar", FAR],
  ["near by", NEAR],
])("from %s what is drawn strays less than a pixel from what was flown, across all blocks", (_, eye) => {
  const points = circuits(8 * 1024);
  const body = bodyOf(points);
  body.choose(eye);
  const line = places(body);
  for (const block of points.blocks) {
    for (let offset = 0; offset < block.count; offset += 61) {
      const point = flownAt(block, offset);
      const seenFrom_m = apart_m(point, [eye.x, eye.y, eye.z]);
      expect(toLine_m(line, point)).toBeLessThan(Math.max(0.07, seenFrom_m * STRAY_RAD * 1.25));
    }
  }
});

test("of a block that reaches far away only what is near is drawn finely", () => {
  // Five points a second: one block is three minutes of flight.
  const points = new TrackPoints();
  for (let index = 0; index < 1025; index += 1) {
    points.add({
      t_s: 1000 + index * 0.2,
      latitude_e7: Math.round(279_300_000 + index * 900),
      longitude_e7: Math.round(-153_800_000 + (index % 2) * 30),
      altitude_mm: 300_000,
    });
  }
  const body = bodyOf(points);
  body.choose(eyeAt(27.93, -15.381, 320));
  const near = Array.from({ length: body.count }, (_, at) => placeOf(body.vertices, at)).filter(
    (place) => apart_m(place, placeOf(body.vertices, 0)) < 600,
  );
  expect(near.length).toBeGreaterThan(50);
  expect(body.count).toBeLessThan(near.length + 150);
});

test("blocks in different levels follow each other without a gap", () => {
  const points = circuits(8 * 1024);
  const body = bodyOf(points);
  body.choose(NEAR);
  const line = places(body);
  for (const block of points.blocks.slice(0, 8)) {
    for (const end of [0, 1023]) {
      const point = flownAt(block, end);
      expect(Math.min(...line.map((place) => apart_m(place, point)))).toBeLessThan(0.01);
    }
  }
  const steps = line.slice(1).map((place, at) => apart_m(place, line[at] ?? []));
  expect(Math.max(...steps)).toBeLessThan(1024 * 0.02 * 80);
});

test("nothing is chosen anew while the eye hardly moves, and a level that is too coarse at once", () => {
  const body = bodyOf(circuits(8 * 1024));
  expect(body.choose(FAR)).toBe(true);
  expect(body.choose(FAR)).toBe(false);
  expect(body.choose({ ...FAR, x: FAR.x + 100 })).toBe(false);
  const before = body.count;
  expect(body.choose(NEAR)).toBe(true);
  expect(body.count).toBeGreaterThan(before);
});

test("the levels follow a flying camera in every fourth picture, and are all right once it rests", () => {
  const body = bodyOf(circuits(8 * 1024));
  const at = (step: number): Eye => ({ ...NEAR, x: NEAR.x + 8 * step });
  body.choose(at(0));
  const flown = Array.from({ length: 400 }, (_, step) => body.choose(at(step + 1)));
  const turns = flown.flatMap((hasChanged, step) => (hasChanged ? [step + 1] : []));
  expect(turns.length).toBeGreaterThan(3);
  expect(turns.filter((step) => step % 4 !== 0)).toEqual([]);
  body.choose(at(401));
  expect(body.isComplete, "the last picture of a moving camera").toBe(false);
  body.choose(at(401));
  expect(body.isComplete, "one more").toBe(true);
  const fresh = bodyOf(circuits(8 * 1024));
  fresh.choose(at(401));
  // A level that is too fine by one stays.
  expect(body.count).toBeGreaterThanOrEqual(fresh.count);
});

test("no level that became wrong is missed, however the camera came there", () => {
  const body = bodyOf(circuits(8 * 1024));
  // Up and back by short steps, to and fro.
  for (let step = 0; step <= 400; step += 1) {
    const eye = eyeAt(27.93, -15.38 + 0.02 * Math.sin(step / 40), 300 + 2000 * Math.cos(step / 60) ** 2);
    body.choose(eye);
    body.choose(eye);
    if (step % 10 === 9) {
      // By another zoom every block is looked at; this one changes no level.
      expect(body.choose({ ...eye, stray_rad: STRAY_RAD * (1 + 1e-9) })).toBe(false);
    }
  }
});

test("another zoom is looked at again from the same place", () => {
  const body = bodyOf(circuits(8 * 1024));
  body.choose(FAR);
  const before = body.count;
  expect(body.choose({ ...FAR, stray_rad: STRAY_RAD / 50 })).toBe(true);
  expect(body.count).toBeGreaterThan(before);
});

test("a line that is written from its first other block on is the line as a whole", () => {
  const body = bodyOf(circuits(8 * 1024));
  let kept_most = 0;
  for (let step = 0; step < 40; step += 1) {
    const eye = eyeAt(27.93 + step * 0.001, -15.38, 320 + 40 * step);
    const [kept, count] = [body.vertices.slice(), body.count];
    if (body.choose(eye)) {
      const whole = body.blocks.reduce((sum, _, index) => sum + lengthOf(body, index), 0);
      expect(whole).toBe(body.count);
      kept_most = Math.max(kept_most, body.changed);
      const unchanged = Math.min(body.changed, count) * POINT_FLOATS;
      expect(body.vertices.slice(0, unchanged)).toEqual(kept.slice(0, unchanged));
      const line = places(body);
      const steps_m = line.slice(1).map((place, at) => apart_m(place, line[at] ?? []));
      expect(Math.max(...steps_m), "no jump between two blocks").toBeLessThan(1024 * 0.02 * 80);
    }
  }
  expect(kept_most).toBeGreaterThan(0);
});

function lengthOf(body: TrackBody, index: number): number {
  return (body.starts[index + 1] ?? body.count) - (body.starts[index] ?? 0);
}

test("a level that is wrong by little may wait for the next picture, and one that is wrong by much may not", () => {
  const body = bodyOf(circuits(8 * 1024));
  const enough = (): boolean => true;
  body.choose(FAR, enough);
  expect(body.isComplete).toBe(true);
  const nearer = eyeAt(27.93, -15.38, 29_000);
  body.choose(nearer, enough);
  expect(body.isComplete).toBe(false);
  body.choose(nearer);
  expect(body.isComplete).toBe(true);
  expect(body.choose(nearer)).toBe(false);
  const before = body.count;
  body.choose(NEAR, enough);
  expect(body.count).toBeGreaterThan(2 * before);
});

test("what is drawn is bounded: noise seen from close by makes all levels coarser instead", () => {
  const body = bodyOf(circuits(100 * 1024, 40));
  body.choose({ ...NEAR, stray_rad: 0.8e-7 });
  expect(body.count).toBeLessThanOrEqual(MAX_BODY_POINTS);
  expect(body.count).toBeGreaterThan(200);
});

test("coarse and fine part of a place keep its centimetres", () => {
  const points = circuits(1024);
  const body = bodyOf(points);
  body.choose(NEAR);
  const [block] = points.blocks;
  expect(block && apart_m(placeOf(body.vertices, 0), flownAt(block, 0))).toBeLessThan(0.01);
  expect(body.vertices.length).toBeGreaterThanOrEqual(body.count * POINT_FLOATS);
});
