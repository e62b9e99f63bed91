import { describe, expect, test } from "vitest";
import { DrawnContext } from "../../test/drawnContext";
import { GROUND } from "../look";
import type { RunwayOf } from "./cell";
import { drawRunway, runwayLength_m } from "./runways";

const LOOK = GROUND.day;
/** Gando's left one: 3100 m. */
const RUNWAY: RunwayOf = {
  ends: ["03L", "21R"],
  length_ft: 10_171,
  width_ft: 148,
  surface: "asphalt",
  isLit: true,
  places: null,
};
const LENGTH_M = 10_171 * 0.3048;

/** Drawn towards the right, with so many pixels for its length. */
function drawn(runway: RunwayOf, length_px: number, down_px = 0) {
  const context = new DrawnContext();
  const ends = [
    { x: 100, y: 50 },
    { x: 100 + length_px, y: 50 + down_px },
  ];
  drawRunway(context as unknown as OffscreenCanvasRenderingContext2D, runway, ends, LOOK);
  return context.drawn;
}

describe("a runway's length", () => {
  test("is what lies between its ends, narrower degrees of longitude included", () => {
    const places = [
      { latitude_deg: 60, longitude_deg: 10 },
      { latitude_deg: 60, longitude_deg: 10.03 },
    ] as const;
    // Half as long as on the equator; what the source tells does not count.
    expect(runwayLength_m({ ...RUNWAY, places, length_ft: 1 })).toBeCloseTo(0.015 * 111_195, 3);
  });

  test("is the one that the source tells where it does not place the ends, or none", () => {
    expect(runwayLength_m(RUNWAY)).toBeCloseTo(LENGTH_M, 6);
    expect(runwayLength_m({ ...RUNWAY, length_ft: null })).toBe(0);
  });
});

test("a runway lies between its ends, as wide as it is", () => {
  const [surface] = drawn(RUNWAY, LENGTH_M / 10);
  const [corner, , opposite] = surface?.lines[0] ?? [];
  const half_px = (148 * 0.3048) / 10 / 2;
  expect(corner?.x).toBeCloseTo(100, 6);
  expect(corner?.y).toBeCloseTo(50 - half_px, 6);
  expect(opposite?.x).toBeCloseTo(100 + LENGTH_M / 10, 6);
  expect(opposite?.y).toBeCloseTo(50 + half_px, 6);
});

test("a runway is turned as its ends lie", () => {
  const [surface] = drawn(RUNWAY, 100, 100);
  expect(surface?.turn_deg).toBeCloseTo(45, 6);
});

test("a runway is seen from afar too: it is never narrower than two and a half pixels", () => {
  const [surface] = drawn(RUNWAY, 30);
  const [above, , below] = surface?.lines[0] ?? [];
  expect((below?.y ?? 0) - (above?.y ?? 0)).toBeCloseTo(2.5, 6);
});

test("a runway of unknown width is as wide as most", () => {
  const [surface] = drawn({ ...RUNWAY, width_ft: null }, LENGTH_M);
  const [above, , below] = surface?.lines[0] ?? [];
  expect((below?.y ?? 0) - (above?.y ?? 0)).toBeCloseTo(25, 6);
});

test.each([
  ["asphalt", LOOK.asphalt],
  ["", LOOK.asphalt],
  ["grass", LOOK.grass],
  ["earth", LOOK.grass],
  ["water", LOOK.water],
  ["snow", LOOK.water],
])("a runway of %j has that surface's colour", (surface, colour) => {
  expect(drawn({ ...RUNWAY, surface }, 300)[0]?.colour).toBe(colour);
});

test("nothing is drawn for a runway whose ends are not known, or lie in one place", () => {
  const context = new DrawnContext();
  const canvas = context as unknown as OffscreenCanvasRenderingContext2D;
  drawRunway(canvas, RUNWAY, [], LOOK);
  drawRunway(canvas, RUNWAY, [{ x: 0, y: 0 }], LOOK);
  const place = { latitude_deg: 28, longitude_deg: -15 };
  drawRunway(
    canvas,
    { ...RUNWAY, places: [place, place] },
    [
      { x: 0, y: 0 },
      { x: 9, y: 0 },
    ],
    LOOK,
  );
  expect(context.drawn).toEqual([]);
});

describe("the paint of a runway", () => {
  test("is there from near on hard ground only", () => {
    expect(drawn(RUNWAY, LENGTH_M).length).toBeGreaterThan(20);
    expect(drawn(RUNWAY, LENGTH_M / 10)).toHaveLength(1);
    expect(drawn({ ...RUNWAY, surface: "concrete" }, LENGTH_M).length).toBeGreaterThan(20);
    expect(drawn({ ...RUNWAY, surface: "grass" }, LENGTH_M)).toHaveLength(1);
    expect(drawn({ ...RUNWAY, surface: "" }, LENGTH_M)).toHaveLength(1);
  });

  test("has at each end its own number, to be read when landing there", () => {
    const texts = drawn(RUNWAY, LENGTH_M).filter(({ kind }) => kind === "text");
    expect(texts.map(({ text }) => text)).toEqual(["03L", "21R"]);
    expect(texts[0]?.lines[0]?.[0]?.x).toBeCloseTo(160, 6);
    expect(texts[1]?.lines[0]?.[0]?.x).toBeCloseTo(100 + LENGTH_M - 60, 6);
    // Towards the right on the picture: the writing runs down for who lands so, and up for who comes against.
    expect(texts[0]?.turn_deg).toBeCloseTo(90, 6);
    expect(texts[1]?.turn_deg).toBeCloseTo(-90, 6);
    expect(texts.every(({ colour }) => colour === LOOK.paint)).toBe(true);
  });

  test("stays on the runway", () => {
    const [surface, ...paint] = drawn(RUNWAY, LENGTH_M);
    const [from, , to] = surface?.lines[0] ?? [];
    for (const { lines } of paint) {
      for (const { x, y } of lines.flat()) {
        expect(x).toBeGreaterThan((from?.x ?? 0) - 1e-6);
        expect(x).toBeLessThan((to?.x ?? 0) + 1e-6);
        expect(y).toBeGreaterThan((from?.y ?? 0) - 1e-6);
        expect(y).toBeLessThan((to?.y ?? 0) + 1e-6);
      }
    }
  });
});
