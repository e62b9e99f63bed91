import { expect, test } from "vitest";
import { TrackPoints } from "../../lib/track/trackPoints";
import { POINT_FLOATS, placeOf } from "../ribbon/vertices";
import { type Tip, TrackTail } from "./tail";

const METRE_DEG = 1 / 111_195;

/** North from Gando, a metre in each 50th of a second. */
function fly(points: TrackPoints, count: number): void {
  for (let done = 0; done < count; done += 1) {
    const index = points.count;
    points.add({
      t_s: 1000 + index * 0.02,
      latitude_e7: Math.round(279_300_000 + index * METRE_DEG * 1e7),
      longitude_e7: -153_800_000,
      altitude_mm: 100_000,
    });
  }
}

/** The aircraft where it is at a time. */
function aircraftAt(t_s: number): Tip {
  const latitude_deg = 27.93 + (t_s - 1000) * 50 * METRE_DEG;
  return { t_s, latitude_deg, longitude_deg: -15.38, altitude_m: 100 };
}

/** Metres that each point of the line lies behind the one after it; all fly in one direction. */
function steps(tail: TrackTail): number[] {
  const line = Array.from({ length: tail.count }, (_, at) => placeOf(tail.vertices, at));
  return line.slice(1).map(([x, y, z], at) => {
    const [fromX, fromY, fromZ] = line[at] ?? [x, y, z];
    const ahead = z - fromZ;
    return Math.hypot(x - fromX, y - fromY, ahead) * Math.sign(ahead === 0 ? 1 : ahead);
  });
}

test("without an aircraft the line ends at the newest point", () => {
  const points = new TrackPoints();
  const tail = new TrackTail(points);
  expect(tail.update(null)).toBe(true);
  fly(points, 10);
  expect(tail.update(null)).toBe(true);
  expect(tail.count).toBe(11);
  expect(tail.update(null)).toBe(false);
});

test("the line ends at the aircraft, along where it was shown since the newest point", () => {
  const points = new TrackPoints();
  const tail = new TrackTail(points);
  fly(points, 100);
  for (let t_s = 1001.98; t_s < 1003; t_s += 1 / 60) {
    tail.update(aircraftAt(t_s));
  }
  const tip = aircraftAt(1003);
  tail.update(tip);
  const [x, y, z] = placeOf(tail.vertices, tail.count - 1);
  const other = new TrackTail(points);
  other.update(tip);
  const [tipX, tipY, tipZ] = placeOf(other.vertices, other.count - 1);
  expect(Math.hypot(x - tipX, y - tipY, z - tipZ)).toBeLessThan(0.01);
  expect(Math.max(...steps(tail).slice(1))).toBeLessThan(4);
  expect(Math.min(...steps(tail).slice(1))).toBeGreaterThan(-0.02);
});

test("points which the shown aircraft has not reached are not drawn before its nose, and come as it reaches them", () => {
  const points = new TrackPoints();
  const tail = new TrackTail(points);
  fly(points, 100);
  tail.update(aircraftAt(1001.5));
  expect(tail.count).toBe(1 + 76 + 1);
  tail.update(aircraftAt(1001.9));
  expect(tail.count).toBe(1 + 96 + 1);
  expect(Math.max(...steps(tail).slice(1))).toBeLessThan(1.1);
});

test("a new block begins with the last point of the one before: nothing is missing between them", () => {
  const points = new TrackPoints();
  const tail = new TrackTail(points);
  fly(points, 1024);
  tail.update(null);
  fly(points, 3);
  tail.update(null);
  expect(tail.count).toBe(4);
  expect(Math.max(...steps(tail))).toBeLessThan(1.1);
  expect(tail.vertices[POINT_FLOATS + 7]).toBe(0);
});

test("no line is drawn to an aircraft that has not flown there", () => {
  const points = new TrackPoints();
  const tail = new TrackTail(points);
  fly(points, 100);
  tail.update({ ...aircraftAt(1002), latitude_deg: 28.2 });
  expect(tail.count).toBe(101);
  tail.update(aircraftAt(1020));
  expect(tail.count).toBe(101);
});

test("who copies only what has changed has the whole line", () => {
  const points = new TrackPoints();
  const tail = new TrackTail(points);
  const copy = new Float32Array(tail.vertices.length);
  for (let step = 0; step < 1200; step += 1) {
    fly(points, 1);
    // It is shown behind its newest point, now more and now less.
    tail.update(
      step % 50 === 49 ? null : aircraftAt(1000 + step * 0.02 - 0.3 * Math.abs(Math.sin(step / 9))),
    );
    const [begin, end] = [tail.changed * POINT_FLOATS, tail.count * POINT_FLOATS];
    copy.set(tail.vertices.subarray(begin, end), begin);
    expect(tail.vertices.subarray(0, end).findIndex((part, at) => part !== copy[at])).toBe(-1);
  }
});
