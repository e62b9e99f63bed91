import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { DrawnContext, DrawnPath, type DrawnPoint, type Stroke } from "../../test/drawnContext";
import { GROUND } from "../look";
import { type AirfieldAt, type Cell, type RunwayOf, SHAPE_UNITS, type Shapes } from "./cell";
import { drawTile } from "./drawTile";
import { northing, type Projection, type TileFrame, WORLD_TILE_PX } from "./tiling";

const LOOK = GROUND.day;
/** 20 to 15 degrees west, 25 to 30 north. */
const PLACE = { level: 2, column: 32, row: 23, size_deg: 5 } as const;
const QUARTER = SHAPE_UNITS / 4;

function shapes(...lines: ReadonlyArray<readonly number[]>): Shapes {
  const starts = [0];
  for (const line of lines) {
    starts.push((starts.at(-1) ?? 0) + line.length / 2);
  }
  return { points: Int32Array.from(lines.flat()), starts: Int32Array.from(starts) };
}

function cell(more: Partial<Cell>): Cell {
  const empty = shapes();
  return {
    place: PLACE,
    land: empty,
    borders: empty,
    towns: [],
    countries: [],
    airfields: [],
    navaids: [],
    ...more,
  };
}

/** Land that the cell's western border has cut: from a quarter to three quarters of the height. */
const CUT = shapes([0, QUARTER, 2 * QUARTER, QUARTER, 2 * QUARTER, 3 * QUARTER, 0, 3 * QUARTER]);

function frame(
  west: number,
  north: number,
  size_deg: number,
  projection: Projection = "geographic",
): TileFrame {
  const pixel_deg = size_deg / WORLD_TILE_PX;
  return {
    west,
    north: northing(projection, north),
    pixel_deg,
    box: { west_deg: west, east_deg: west + size_deg, south_deg: north - size_deg, north_deg: north },
    metresPerPixel: pixel_deg * 111_195,
  };
}

/** The tile that is just the cell, and one of 22 m in a pixel about a place. */
const WHOLE = frame(-20, 30, 5);
function near(longitude_deg: number, latitude_deg: number): TileFrame {
  return frame(longitude_deg - 0.025, latitude_deg + 0.025, 0.05);
}

function drawn(
  cells: readonly Cell[],
  at: TileFrame,
  opacity = 1,
  projection: Projection = "geographic",
): Stroke[] {
  const context = new DrawnContext();
  drawTile(context as unknown as OffscreenCanvasRenderingContext2D, projection, at, cells, LOOK, opacity);
  return context.drawn;
}

function ofColour(all: readonly Stroke[], colour: string): readonly Stroke[] {
  return all.filter((one) => one.colour === colour);
}

function rounded(lines: ReadonlyArray<readonly DrawnPoint[]> | undefined): number[][][] {
  return (lines ?? []).map((line) =>
    line.map(({ x, y }) => [Math.round(x * 1e6) / 1e6, Math.round(y * 1e6) / 1e6]),
  );
}

beforeEach(() => void vi.stubGlobal("Path2D", DrawnPath));
afterEach(() => vi.unstubAllGlobals());

describe("a tile of the map", () => {
  test("without any cell is sea from edge to edge", () => {
    const all = drawn([], WHOLE);
    expect(all).toHaveLength(1);
    expect(all[0]).toMatchObject({ kind: "rectangle", colour: LOOK.sea });
    expect(rounded(all[0]?.lines)).toEqual([
      [
        [0, 0],
        [256, 0],
        [256, 256],
        [0, 256],
      ],
    ]);
  });

  test("has the land where it lies, north up, and over it first borders and then the coast", () => {
    const all = drawn([cell({ land: CUT })], WHOLE);
    expect(all.map(({ colour }) => colour)).toEqual([LOOK.sea, LOOK.land, LOOK.border, LOOK.coast]);
    expect(rounded(all[1]?.lines)).toEqual([
      [
        [0, 192],
        [128, 192],
        [128, 64],
        [0, 64],
        [0, 192],
      ],
    ]);
  });

  test("has no coast where only the cell's border has cut the land", () => {
    const [coast] = ofColour(drawn([cell({ land: CUT })], WHOLE), LOOK.coast);
    expect(rounded(coast?.lines)).toEqual([
      [
        [0, 192],
        [128, 192],
        [128, 64],
        [0, 64],
      ],
    ]);
  });

  test.each([
    ["eastern", [SHAPE_UNITS, QUARTER, SHAPE_UNITS, 2 * QUARTER, QUARTER, QUARTER]],
    ["northern", [QUARTER, SHAPE_UNITS, 2 * QUARTER, SHAPE_UNITS, QUARTER, QUARTER]],
    ["southern", [QUARTER, 0, 2 * QUARTER, 0, QUARTER, QUARTER]],
  ])("has no coast along the cell's %s border either", (_, ring) => {
    const [coast] = ofColour(drawn([cell({ land: shapes(ring) })], WHOLE), LOOK.coast);
    // Two of the three edges are left.
    expect(coast?.lines.flatMap((line) => line.slice(1))).toHaveLength(2);
  });

  test("leaves the water of a lake free: both rings are filled at once by the even-odd rule", () => {
    const island = [0, 0, 4 * QUARTER, 0, 4 * QUARTER, 4 * QUARTER];
    const lake = [2 * QUARTER, QUARTER, 3 * QUARTER, QUARTER, 3 * QUARTER, 2 * QUARTER];
    const [land] = ofColour(drawn([cell({ land: shapes(island, lake) })], WHOLE), LOOK.land);
    expect(land?.rule).toBe("evenodd");
    expect(rounded(land?.lines)).toEqual([
      [
        [0, 256],
        [256, 256],
        [256, 0],
        [0, 256],
      ],
      [
        [128, 192],
        [192, 192],
        [192, 128],
        [128, 192],
      ],
    ]);
  });

  test("draws borders as open lines, along the cell's border too", () => {
    const line = [0, 0, 0, QUARTER, QUARTER, 2 * QUARTER];
    const [border] = ofColour(drawn([cell({ borders: shapes(line) })], WHOLE), LOOK.border);
    expect(rounded(border?.lines)).toEqual([
      [
        [0, 256],
        [0, 192],
        [64, 128],
      ],
    ]);
  });

  test("draws lines as wide on every scale", () => {
    for (const at of [WHOLE, near(-17.5, 26.25), frame(-40, 60, 40)]) {
      const all = drawn([cell({ land: CUT })], at);
      expect(ofColour(all, LOOK.coast)[0]?.width_px).toBeCloseTo(1.4, 6);
      expect(ofColour(all, LOOK.border)[0]?.width_px).toBeCloseTo(1.6, 6);
    }
  });

  test("joins the cells that it shows", () => {
    const east = cell({ land: CUT, place: { ...PLACE, column: 33 } });
    const both = ofColour(drawn([cell({ land: CUT }), east], frame(-20, 30, 10)), LOOK.land);
    expect(both.map(({ lines }) => lines[0]?.[0]?.x)).toEqual([0, 128]);
  });

  test("draws a coast of many points without a gap", () => {
    const points = Array.from({ length: 300 }, (_, index) => [1000 + 100 * index, 5000 + 40 * (index % 2)]);
    const [border] = ofColour(drawn([cell({ borders: shapes(points.flat()) })], WHOLE), LOOK.border);
    expect(border?.lines.length).toBeGreaterThan(1);
    for (const [index, line] of (border?.lines ?? []).entries()) {
      expect(line[0]).toEqual(border?.lines[index - 1]?.at(-1) ?? line[0]);
    }
    expect(border?.lines.flatMap((line) => line.slice(1))).toHaveLength(299);
  });

  test("does not draw the parts of a line that lie far beside it", () => {
    const points = Array.from({ length: 400 }, (_, index) => [index * 80, 2 * QUARTER]);
    const [whole] = ofColour(drawn([cell({ borders: shapes(points.flat()) })], WHOLE), LOOK.border);
    // Around the line's western end.
    const [part] = ofColour(drawn([cell({ borders: shapes(points.flat()) })], near(-20, 27.5)), LOOK.border);
    expect(whole?.lines.length).toBeGreaterThan(3);
    expect(part?.lines).toHaveLength(1);
    const [none] = ofColour(drawn([cell({ borders: shapes(points.flat()) })], near(-20, 29)), LOOK.border);
    expect(none?.lines).toEqual([]);
  });

  test("makes a cell's shapes once, however often it is drawn", () => {
    const gran = cell({ land: CUT });
    const [first] = ofColour(drawn([gran], WHOLE), LOOK.land);
    const [again] = ofColour(drawn([gran], near(-18, 27)), LOOK.land);
    expect(again?.path).toBe(first?.path);
    const [mercator] = ofColour(drawn([gran], WHOLE, 1, "mercator"), LOOK.land);
    expect(mercator?.path).not.toBe(first?.path);
  });

  test("of Web Mercator has each point at its latitude there", () => {
    const at = frame(-20, 30, 6, "mercator");
    const [land] = ofColour(drawn([cell({ land: CUT })], at, 1, "mercator"), LOOK.land);
    const down = (latitude_deg: number): number =>
      (at.north - northing("mercator", latitude_deg)) / at.pixel_deg;
    const ys = (land?.lines[0] ?? []).map(({ y }) => y);
    [26.25, 26.25, 28.75, 28.75].forEach((latitude_deg, index) => {
      expect(ys[index]).toBeCloseTo(down(latitude_deg), 6);
    });
  });
});

describe("the shallows", () => {
  test("lie on both sides of the coast under the land, 900 m wide", () => {
    const all = drawn([cell({ land: CUT })], near(-17.5, 26.25));
    expect(all.map(({ colour }) => colour).slice(0, 3)).toEqual([LOOK.sea, LOOK.shallows, LOOK.land]);
    expect(all[1]?.width_px).toBeCloseTo(1800 / near(0, 0).metresPerPixel, 6);
  });

  test("are left out where they would be a line, where they would fill the tile, and over a picture", () => {
    const gran = [cell({ land: CUT })];
    expect(ofColour(drawn(gran, WHOLE), LOOK.shallows)).toEqual([]);
    expect(ofColour(drawn(gran, frame(-17.5, 26.26, 0.02)), LOOK.shallows)).toEqual([]);
    expect(ofColour(drawn(gran, near(-17.5, 26.25), 0.8), LOOK.shallows)).toEqual([]);
  });
});

test("a picture of the Earth shows through sea and land, but not through coast and borders", () => {
  const all = drawn([cell({ land: CUT })], WHOLE, 0.4);
  expect(all.map(({ alpha }) => alpha)).toEqual([0.4, 0.4, 1, 1]);
});

describe("runways", () => {
  const runway: RunwayOf = {
    ends: ["18", "36"],
    length_ft: null,
    width_ft: 100,
    surface: "grass",
    isLit: false,
    places: [
      { latitude_deg: 27.01, longitude_deg: -17 },
      { latitude_deg: 26.99, longitude_deg: -17 },
    ],
  };
  const field: AirfieldAt = {
    latitude_deg: 27,
    longitude_deg: -17,
    code: "XXXX",
    name: "",
    elevation_ft: null,
    kind: "",
    weight: 2,
    runways: [runway],
    frequencies: null,
  };
  const gran = cell({ airfields: [field] });

  test("lie over all else, from end to end", () => {
    const last = drawn([gran], near(-17, 27)).at(-1);
    expect(last?.colour).toBe(LOOK.grass);
    const xs = (last?.lines[0] ?? []).map(({ x }) => x);
    const ys = (last?.lines[0] ?? []).map(({ y }) => y);
    expect((Math.min(...xs) + Math.max(...xs)) / 2).toBeCloseTo(128, 6);
    expect(Math.max(...ys) - Math.min(...ys)).toBeCloseTo((0.02 / 0.05) * 256, 6);
  });

  test("are left out where they would be dots", () => {
    expect(ofColour(drawn([gran], WHOLE), LOOK.grass)).toEqual([]);
  });

  test("of an airfield just beyond the tile reach into it, those far away are not drawn", () => {
    const sees = (longitude_deg: number, latitude_deg: number): boolean =>
      ofColour(drawn([gran], near(longitude_deg, latitude_deg)), LOOK.grass).length > 0;
    expect(sees(-17.1, 27)).toBe(true);
    expect(sees(-17, 27.1)).toBe(true);
    expect([sees(-17.2, 27), sees(-16.8, 27)]).toEqual([false, false]);
    expect([sees(-17, 27.12), sees(-17, 26.88)]).toEqual([false, false]);
  });

  test("that a coarse cell does not hold, or that have no places, are not drawn", () => {
    const coarse = cell({ airfields: [{ ...field, runways: null }] });
    const placeless = cell({
      airfields: [{ ...field, runways: [{ ...runway, length_ft: 3000, places: null }] }],
    });
    expect(ofColour(drawn([coarse, placeless], near(-17, 27)), LOOK.grass)).toEqual([]);
  });

  test("lie at their latitude on Web Mercator too", () => {
    const at = frame(-17.025, 27.025, 0.05, "mercator");
    const last = drawn([gran], at, 1, "mercator").at(-1);
    const ys = (last?.lines[0] ?? []).map(({ y }) => y);
    expect(Math.min(...ys)).toBeCloseTo((at.north - northing("mercator", 27.01)) / at.pixel_deg, 3);
  });
});
