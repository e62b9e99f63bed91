import { expect, test } from "vitest";
import type { Position } from "../../lib/geodesy";
import { BLOCK_POINTS } from "../../lib/track/block";
import { type TrackPoint, TrackPoints } from "../../lib/track/trackPoints";
import { FlatTrack, type FlatTrackLook } from "./FlatTrack";
import { around, type FlatView, type ScreenPoint, toScreen } from "./projection";

const GANDO = { latitude_deg: 27.93, longitude_deg: -15.38 };
const VIEW: FlatView = { centre: GANDO, zoom: 14, width_px: 800, height_px: 600 };
const LOOK: FlatTrackLook = { plain: "#ffd91a", casing: "#12100a", colouring: "none", range: null };

interface LineStroke {
  readonly colour: string;
  readonly points: readonly ScreenPoint[];
}

/** What a track draws when all of it is made, stroke by stroke, without the dark edge below it. */
function drawn(track: FlatTrack, view: FlatView, look = LOOK): readonly LineStroke[] {
  const strokes: LineStroke[] = [];
  let points: ScreenPoint[] = [];
  const context = {
    strokeStyle: "",
    beginPath: () => {
      points = [];
    },
    moveTo: (x: number, y: number) => points.push({ x, y }),
    lineTo: (x: number, y: number) => points.push({ x, y }),
    stroke: () => strokes.push({ colour: context.strokeStyle, points }),
  };
  do {
    strokes.length = 0;
    track.draw(context as unknown as CanvasRenderingContext2D, view, look);
  } while (!track.isComplete);
  return strokes.filter(({ colour }) => colour !== look.casing);
}

/** A flight to the north at 50 points a second that weaves; about 30 m/s. */
function flight(count: number): TrackPoints {
  const points = new TrackPoints();
  for (let index = 0; index < count; index += 1) {
    points.add(packed(index));
  }
  return points;
}

function at(index: number): Position {
  return {
    latitude_deg: GANDO.latitude_deg + index * 5.4e-6,
    longitude_deg: GANDO.longitude_deg + 0.002 * Math.sin(index / 200),
  };
}

function packed(index: number): TrackPoint {
  const { latitude_deg, longitude_deg } = at(index);
  return {
    t_s: 1_700_000_000 + index / 50,
    latitude_e7: Math.round(latitude_deg * 1e7),
    longitude_e7: Math.round(longitude_deg * 1e7),
    altitude_mm: 100_000 + index * 20,
  };
}

function awayFrom(points: readonly ScreenPoint[], { x, y }: ScreenPoint): number {
  return Math.min(
    ...points.slice(1).map((to, index) => {
      const from = points[index] ?? to;
      const [dx, dy] = [to.x - from.x, to.y - from.y];
      const square = dx * dx + dy * dy;
      const along =
        square === 0 ? 0 : Math.max(0, Math.min(1, ((x - from.x) * dx + (y - from.y) * dy) / square));
      return Math.hypot(x - from.x - along * dx, y - from.y - along * dy);
    }),
  );
}

test("a long track is drawn with few points, none of it farther than a pixel from what was flown, to its newest", () => {
  const count = 5 * BLOCK_POINTS + 300;
  const points = flight(count);
  const view = around(VIEW, [at(0), at(count - 1)]);
  const [line, ...others] = drawn(new FlatTrack(points), view);
  expect(others).toEqual([]);
  // All of the newest block, and of the frozen ones what the scale shows.
  expect(line?.points.length).toBeLessThan(600);
  for (let index = 0; index < count; index += 17) {
    expect(awayFrom(line?.points ?? [], toScreen(view, at(index)))).toBeLessThan(1);
  }
  const last = line?.points.at(-1);
  const newest = toScreen(view, at(count - 1));
  expect(last?.x).toBeCloseTo(newest.x, 1);
  expect(last?.y).toBeCloseTo(newest.y, 1);
});

test("what lies far outside costs no points, and the line comes in where it does", () => {
  const count = 12 * BLOCK_POINTS;
  const track = new FlatTrack(flight(count));
  const near = { ...VIEW, centre: at(6 * BLOCK_POINTS), zoom: 17 };
  const line = drawn(track, near)[0]?.points ?? [];
  const inside = line.filter(({ x, y }) => x > 0 && x < 800 && y > 0 && y < 600);
  expect(inside.length).toBeGreaterThan(10);
  expect(line.length - inside.length).toBeLessThan(2 * inside.length + 60);
  expect(awayFrom(line, { x: 400, y: 300 })).toBeLessThan(1);
});

test("an interruption of the flight is a gap", () => {
  const points = flight(50);
  points.add(packed(5000));
  points.add(packed(5001));
  expect(drawn(new FlatTrack(points), VIEW).length).toBe(2);
});

test("values colour it from one end of their scale to the other", () => {
  const range = { least: 100, most: 100 + 2000 / 50 };
  const colours = drawn(new FlatTrack(flight(2000)), VIEW, { ...LOOK, colouring: "height", range }).map(
    ({ colour }) => colour,
  );
  expect(new Set(colours).size).toBeGreaterThan(10);
});

test("it has news while the flight goes on, and none when that has been drawn", () => {
  const points = flight(10);
  const track = new FlatTrack(points);
  expect(track.hasNews).toBe(true);
  drawn(track, VIEW);
  expect(track.hasNews).toBe(false);
  points.add(packed(10));
  expect(track.hasNews).toBe(true);
});
