import { createHash } from "node:crypto";
import { gunzipSync } from "node:zlib";
import { describe, expect, test } from "vitest";
import { distance_m } from "../../lib/geodesy";
import { askWorld, packedCell, WORLD_CELLS, WORLD_LEVELS, WORLD_SHA256 } from "../../test/worldMap";
import { type Cell, type CellPlace, decodeCell, SHAPE_UNITS } from "./cell";
import { CellStore } from "./cellStore";
import { boxOf } from "./geometry";
import { runwayLength_m } from "./runways";
import { highest, nearestOf, thingsIn } from "./things";
import { cellsOf } from "./tiling";

function read(place: CellPlace): Cell {
  return decodeCell(gunzipSync(packedCell(place.level, `${place.column}-${place.row}`)), place);
}

/** The square of five degrees with Gran Canaria. */
const HOME = read({ level: 2, column: 32, row: 23, size_deg: 5 });

/** As GeoNames has them: name, latitude, longitude. */
const KNOWN = [
  ["Las Palmas de Gran Canaria", 28.10178, -15.41573],
  ["Telde", 27.99243, -15.41915],
  ["Maspalomas", 27.76056, -15.58602],
  ["Arucas", 28.11983, -15.52325],
  ["Gáldar", 28.14701, -15.6502],
  ["Agüimes", 27.90539, -15.44609],
  ["Ingenio", 27.91855, -15.43433],
  ["Mogán", 27.88385, -15.72538],
  ["Teror", 28.06062, -15.54909],
  ["Tejeda", 27.99508, -15.61543],
  ["Santa Brígida", 28.03197, -15.50425],
  ["Vecindario", 27.84636, -15.44455],
  ["Puerto Rico", 27.78943, -15.71045],
  ["Agaete", 28.10023, -15.69998],
  ["Firgas", 28.10711, -15.56299],
  ["Moya", 28.11106, -15.58285],
  ["Valleseco", 28.0433, -15.57623],
  ["San Mateo", 28.00892, -15.5333],
  ["Artenara", 28.02055, -15.64693],
] as const;

describe("twenty names of Gran Canaria that people know", () => {
  test.each(KNOWN)("%s stands within 100 m of the source's place", (name, latitude_deg, longitude_deg) => {
    const named = HOME.towns.filter((town) => town.name.includes(name));
    const away_m = named.map((town) => distance_m(town, { latitude_deg, longitude_deg }));
    expect(Math.min(...away_m)).toBeLessThan(100);
  });

  test("GCLP stands at its reference point, with both runways, elevation and frequencies", () => {
    const gando = HOME.airfields.find(({ code }) => code === "GCLP");
    expect(
      distance_m(gando ?? assertFound(), { latitude_deg: 27.9319, longitude_deg: -15.3866 }),
    ).toBeLessThan(100);
    expect(gando?.elevation_ft).toBe(78);
    expect(gando?.runways?.map(({ ends }) => ends.join("/")).sort()).toEqual(["03L/21R", "03R/21L"]);
    for (const runway of gando?.runways ?? []) {
      expect(runwayLength_m(runway)).toBeGreaterThan(3050);
      expect(runwayLength_m(runway)).toBeLessThan(3150);
    }
    expect(gando?.frequencies).toContainEqual({ type: "TWR", description: "", mhz: 118.3 });
  });
});

test("the radio beacons of the island are there with their frequencies", () => {
  const beacon = HOME.navaids.find(({ code, type }) => code === "LPC" && type === "VOR-DME");
  expect(beacon).toMatchObject({ frequency_khz: 115_000, dmeChannel: "097X" });
});

test("both runways of Gando lie on land, and the sea beside them does not", () => {
  const runways = HOME.airfields.find(({ code }) => code === "GCLP")?.runways ?? [];
  const ends = runways.flatMap(({ places }) => places ?? []);
  expect(ends).toHaveLength(4);
  for (const end of ends) {
    expect(isLand(HOME, end)).toBe(true);
  }
  expect(isLand(HOME, { latitude_deg: 27.93, longitude_deg: -15.33 })).toBe(false);
});

test("the coast around home is as fine as the source, 126 m from point to point", () => {
  const { points, starts } = HOME.land;
  const largest = [...starts.keys()]
    .slice(0, -1)
    .map((shape) => (starts[shape + 1] ?? 0) - (starts[shape] ?? 0))
    .sort((one, other) => other - one);
  expect(points.length / 2).toBeGreaterThan(4000);
  expect(largest[0]).toBeGreaterThan(900);
});

test("a file that is cut anywhere is refused, and never half a cell", () => {
  const bytes = gunzipSync(packedCell(2, "32-23"));
  for (const share of [0, 0.01, 0.3, 0.7, 0.95, 0.999]) {
    const cut = bytes.subarray(0, Math.floor(share * bytes.length));
    expect(() => decodeCell(cut, HOME.place)).toThrow();
  }
});

test("every cell of the index can be unpacked, and every level names its largest towns", () => {
  for (const [level, { cells }] of Object.entries(WORLD_LEVELS)) {
    const names = Object.keys(cells);
    expect(names.length).toBeGreaterThan(1);
    expect(names.filter((cell) => gunzipSync(packedCell(Number(level), cell)).length < 4)).toEqual([]);
  }
  expect(createHash("sha256").update(WORLD_CELLS).digest("hex")).toBe(WORLD_SHA256);
  const world = [0, 1].map((column) => read({ level: 0, column, row: 0, size_deg: 180 }));
  const names = world.flatMap(({ towns }) => towns.map(({ name }) => name));
  expect(names).toEqual(expect.arrayContaining(["Madrid", "London", "Tokyo", "Lagos", "Lima"]));
  expect(world.flatMap(({ countries }) => countries.map(({ code }) => code))).toEqual(
    expect.arrayContaining(["ES", "NL", "CH", "AU"]),
  );
});

describe("the things of a view", () => {
  const gando = { latitude_deg: 27.93, longitude_deg: -15.39 };
  const near = { level: 2, from_m: 0, to_m: 60_000 } as const;

  test("come with the highest rank first, and only from their zone", () => {
    const things = highest(thingsIn(HOME, near, gando, 30_000), 60);
    expect(things.length).toBeGreaterThan(30);
    const ranks = things.map(({ rank }) => rank);
    expect(ranks).toEqual([...ranks].sort((one, other) => other - one));
    expect(things.every((thing) => distance_m(thing, gando) < 60_000)).toBe(true);
    const names = things.map((thing) => (thing.kind === "town" ? thing.name : thing.key));
    expect(names.slice(0, 5)).toEqual(expect.arrayContaining(["Las Palmas de Gran Canaria", "aGCLP"]));
  });

  test("the nearest airfields are listed by distance, without helicopters' pads", () => {
    const airfields = nearestOf([HOME], gando, 5);
    expect(airfields[0]?.airfield.code).toBe("GCLP");
    const away = airfields.map(({ away_m }) => away_m);
    expect(away).toEqual([...away].sort((one, other) => one - other));
    expect(airfields.every(({ airfield }) => airfield.kind === "")).toBe(true);
  });
});

test("cells are asked for once, and one that failed is asked for again", async () => {
  const asked: string[] = [];
  let isAway = false;
  const store = new CellStore((address, headers) => {
    asked.push(address);
    return isAway ? Promise.resolve(new Response("", { status: 503 })) : askWorld(address, headers);
  });
  const box = boxOf([
    [-15.5, 27.8],
    [-15.3, 28],
  ]);
  expect(await store.within(2, box)).toHaveLength(1);
  await store.within(2, box);
  expect(asked).toEqual(["/map/world/index.json", "/map/world/cells.bin"]);
  isAway = true;
  const other = { ...box, west_deg: -6, east_deg: -5.9 };
  await expect(store.within(2, other)).rejects.toThrow("503");
  isAway = false;
  expect(await store.within(2, other)).toHaveLength(1);
});

test("a server that knows no parts of files gives the same cell", async () => {
  const box = boxOf([
    [-15.5, 27.8],
    [-15.3, 28],
  ]);
  const [whole] = await new CellStore((address) => askWorld(address)).within(2, box);
  expect(whole).toEqual(HOME);
});

test("the open sea has no cell, and the poles have theirs", () => {
  expect(cellsOf(2, 5, { west_deg: -180, east_deg: 180, south_deg: -90, north_deg: -90 })).toHaveLength(72);
  expect(cellsOf(2, 5, { west_deg: -190, east_deg: -181, south_deg: 0, north_deg: 1 })).toHaveLength(1);
});

/** By the even-odd rule: how many edges lie to the east. */
function isLand({ place, land }: Cell, at: { latitude_deg: number; longitude_deg: number }): boolean {
  const x = ((at.longitude_deg + 180 - place.column * place.size_deg) / place.size_deg) * SHAPE_UNITS;
  const y = ((at.latitude_deg + 90 - place.row * place.size_deg) / place.size_deg) * SHAPE_UNITS;
  let isInside = false;
  for (let shape = 0; shape + 1 < land.starts.length; shape += 1) {
    const [from = 0, to = 0] = [land.starts[shape], land.starts[shape + 1]];
    for (let point = from, before = to - 1; point < to; before = point, point += 1) {
      const [x0 = 0, y0 = 0] = [land.points[2 * before], land.points[2 * before + 1]];
      const [x1 = 0, y1 = 0] = [land.points[2 * point], land.points[2 * point + 1]];
      if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) {
        isInside = !isInside;
      }
    }
  }
  return isInside;
}

function assertFound(): never {
  throw new Error("not on the map");
}
