import { describe, expect, test } from "vitest";
import type { Position } from "../../../lib/geodesy";
import type { MapLayer } from "../../../protocol/mapLayers";
import { TerrainHeights } from "./terrainHeights";

const WORLD = { west_deg: -180, south_deg: -90, east_deg: 180, north_deg: 90 };
const GANDO: Position = { latitude_deg: 27.93, longitude_deg: -15.38 };

function layer(id: string, more: Partial<MapLayer> = {}): MapLayer {
  return { ...WORLD, id, ...more } as MapLayer;
}

/** A tile whose ground rises evenly from its western edge to its eastern one; as the format asks for it. */
function slope(west_m: number, east_m: number): ArrayBuffer {
  const bytes = new DataView(new ArrayBuffer(92 + 6 * 4 + 4 + 2 * 6));
  bytes.setFloat32(24, west_m, true);
  bytes.setFloat32(28, east_m, true);
  bytes.setUint32(88, 4, true);
  // Around the tile from its south-west: differences to the point before, the sign in the lowest bit.
  const [up, down] = [2 * 32_767, 2 * 32_767 - 1];
  const east = [0, up, 0, down];
  const north = [0, 0, up, 0];
  [...east, ...north, ...east].forEach((code, at) => {
    bytes.setUint16(92 + 2 * at, code, true);
  });
  bytes.setUint32(116, 2, true);
  [0, 0, 0, 3, 1, 0].forEach((code, at) => {
    bytes.setUint16(120 + 2 * at, code, true);
  });
  return bytes.buffer;
}

type Files = Record<string, ArrayBuffer | object | number>;

/** A station with these files by what follows the layers' folder: tiles, texts, or the status of a refusal. */
function station(files: Files) {
  const asked: string[] = [];
  const link = { isUp: true };
  const heights = new TerrainHeights((path) => {
    const name = path.replace("/api/v1/map/layers/", "");
    asked.push(name);
    if (!link.isUp) {
      return Promise.reject(new TypeError("no link"));
    }
    const file = files[name] ?? 404;
    if (typeof file === "number") {
      return Promise.resolve(new Response("", { status: file }));
    }
    return Promise.resolve(new Response(file instanceof ArrayBuffer ? file : JSON.stringify(file)));
  });
  return { heights, asked, link };
}

/** The whole world in two tiles, of these heights. */
function whole(id: string, west_m: number, east_m = west_m, scheme: object = { maxzoom: 0 }): Files {
  return {
    [`${id}/terrain/layer.json`]: scheme,
    [`${id}/terrain/0/0/0.terrain`]: slope(west_m, east_m),
    [`${id}/terrain/0/1/0.terrain`]: slope(west_m, east_m),
  };
}

function east(longitude_deg: number, latitude_deg = 1): Position {
  return { latitude_deg, longitude_deg };
}

describe("the ground's height below a place", () => {
  test("is read from the tile at its place in it", async () => {
    const { heights } = station(whole("a", 0, 1000));
    const found = await heights.at([east(-180), east(-135), east(-90), east(90), east(180)], [layer("a")]);
    [0, 250, 500, 500, 1000].forEach((height_m, index) => {
      expect(found[index]).toBeCloseTo(height_m, 1);
    });
  });

  test("is not known without a terrain, or where none covers the place", async () => {
    const { heights, asked } = station(whole("a", 100));
    expect(await heights.at([GANDO], [])).toEqual([null]);
    const elsewhere = [
      layer("a", { west_deg: -15 }),
      layer("a", { east_deg: -16 }),
      layer("a", { south_deg: 28 }),
      layer("a", { north_deg: 27 }),
    ];
    expect(await heights.at([GANDO], elsewhere)).toEqual([null]);
    expect(asked).toEqual([]);
  });

  test("comes from the first terrain that has it, and from the next where that one has none", async () => {
    const files = { ...whole("a", 100), ...whole("b", 900) };
    delete files["a/terrain/0/1/0.terrain"];
    const { heights } = station(files);
    const found = await heights.at([east(-10), east(10)], [layer("a"), layer("b")]);
    expect(found[0]).toBeCloseTo(100, 3);
    expect(found[1]).toBeCloseTo(900, 3);
  });

  test("asks no other terrain once all heights are known", async () => {
    const { heights, asked } = station({ ...whole("a", 100), ...whole("b", 900) });
    await heights.at([east(-10)], [layer("a"), layer("b")]);
    expect(asked.filter((name) => name.startsWith("b"))).toEqual([]);
  });

  test("of a terrain whose name has signs in it is asked for with these written out", async () => {
    const { heights, asked } = station({});
    await heights.at([GANDO], [layer("a b/c")]);
    expect(asked[0]).toBe("a%20b%2Fc/terrain/layer.json");
  });
});

describe("a tile", () => {
  // Gando in tiles of 22.5 degrees: column 7 from the west, row 5 of 0..7 from the south.
  test("is asked for by its row from the south, as the globe does", async () => {
    const { heights, asked } = station({
      "a/terrain/layer.json": { maxzoom: 3, scheme: "tms" },
      "a/terrain/3/7/5.terrain": slope(77, 77),
    });
    expect((await heights.at([GANDO], [layer("a")]))[0]).toBeCloseTo(77, 3);
    expect(asked.slice(1)).toEqual(["a/terrain/3/7/5.terrain"]);
  });

  test("is asked for by its row from the north where the terrain is written so", async () => {
    const { heights, asked } = station({
      "a/terrain/layer.json": { maxzoom: 3, scheme: "slippyMap", projection: "EPSG:4326" },
      "a/terrain/3/7/2.terrain": slope(77, 77),
    });
    expect((await heights.at([GANDO], [layer("a")]))[0]).toBeCloseTo(77, 3);
    expect(asked.slice(1)).toEqual(["a/terrain/3/7/2.terrain"]);
  });

  test("that is missing is replaced by the next coarser one", async () => {
    const { heights, asked } = station({ ...whole("a", 50), "a/terrain/layer.json": { maxzoom: 2 } });
    expect((await heights.at([GANDO], [layer("a")]))[0]).toBeCloseTo(50, 3);
    expect(asked.slice(1)).toEqual([
      "a/terrain/2/3/2.terrain",
      "a/terrain/1/1/1.terrain",
      "a/terrain/0/0/0.terrain",
    ]);
  });

  test("is looked for no more than six levels higher", async () => {
    const { heights, asked } = station({ ...whole("a", 50), "a/terrain/layer.json": { maxzoom: 8 } });
    expect(await heights.at([GANDO], [layer("a")])).toEqual([null]);
    expect(asked.slice(1).map((name) => name.split("/")[2])).toEqual(["8", "7", "6", "5", "4", "3", "2"]);
  });

  test("that is cut off counts as missing", async () => {
    const files = { ...whole("a", 50), "a/terrain/layer.json": { maxzoom: 1 } };
    const { heights } = station({ ...files, "a/terrain/1/1/1.terrain": slope(9, 9).slice(0, 100) });
    expect((await heights.at([GANDO], [layer("a")]))[0]).toBeCloseTo(50, 3);
  });

  test("is asked for once, for however many places and profiles", async () => {
    const { heights, asked } = station(whole("a", 50));
    await heights.at([east(-10), east(-20), east(-30)], [layer("a")]);
    await heights.at([east(-40)], [layer("a")]);
    expect(asked).toEqual(["a/terrain/layer.json", "a/terrain/0/0/0.terrain"]);
  });

  test("that was read long ago is asked for again after many others", async () => {
    const { heights, asked } = station({ ...whole("a", 50), "a/terrain/layer.json": { maxzoom: 7 } });
    const place = (step: number): Position => east(-179 + step * 1.5);
    await heights.at([place(0)], [layer("a")]);
    const first = asked[1];
    for (let step = 1; step < 140; step += 1) {
      await heights.at([place(step)], [layer("a")]);
    }
    await heights.at([place(0)], [layer("a")]);
    expect(asked.filter((name) => name === first)).toHaveLength(2);
  });

  test("at the north pole and at the date line is the map's last", async () => {
    const { heights, asked } = station({
      "a/terrain/layer.json": { maxzoom: 2 },
      "a/terrain/2/7/3.terrain": slope(5, 5),
    });
    expect((await heights.at([east(180, 90)], [layer("a")]))[0]).toBeCloseTo(5, 3);
    expect(asked).toContain("a/terrain/2/7/3.terrain");
  });
});

test("a long plan is read from coarser tiles: never more than 48 for one profile", async () => {
  const { heights, asked } = station({ ...whole("a", 50), "a/terrain/layer.json": { maxzoom: 6 } });
  const places = Array.from({ length: 120 }, (_, index) => east(-179 + 2.8 * index));
  const found = await heights.at(places, [layer("a")]);
  expect(found.every((height_m) => height_m !== null && Math.abs(height_m - 50) < 0.01)).toBe(true);
  const levels = asked.slice(1).map((name) => Number(name.split("/")[2]));
  // 2.8 degrees in tiles of 5.6 are 60 of them, of 11.25 half as many.
  expect(Math.max(...levels)).toBe(4);
  expect(levels.filter((level) => level === 4).length).toBeLessThanOrEqual(48);
});

describe("a terrain", () => {
  test.each([
    ["that the station refuses", 503],
    ["that is no object", ["tms"]],
    ["of another projection", { maxzoom: 0, projection: "EPSG:3857" }],
  ])("%s gives no heights, and the next one is taken", async (_, scheme) => {
    const { heights, asked } = station({
      ...whole("a", 1),
      ...whole("b", 2),
      "a/terrain/layer.json": scheme,
    });
    expect((await heights.at([GANDO], [layer("a"), layer("b")]))[0]).toBeCloseTo(2, 3);
    expect(asked.filter((name) => name.startsWith("a"))).toEqual(["a/terrain/layer.json"]);
  });

  test("that does not say how fine it is has its coarsest tiles", async () => {
    const { heights } = station(whole("a", 30, 30, { maxzoom: "many" }));
    expect((await heights.at([GANDO], [layer("a")]))[0]).toBeCloseTo(30, 3);
  });
});

describe("a station that does not answer", () => {
  test("leaves the heights unknown, and is asked again for the next profile", async () => {
    const { heights, link } = station(whole("a", 40));
    link.isUp = false;
    expect(await heights.at([GANDO], [layer("a")])).toEqual([null]);
    link.isUp = true;
    expect((await heights.at([GANDO], [layer("a")]))[0]).toBeCloseTo(40, 3);
  });

  test("in the middle of a profile is asked again for its tiles too", async () => {
    const { heights, link } = station(whole("a", 40));
    await heights.at([east(10)], [layer("a")]);
    link.isUp = false;
    expect(await heights.at([GANDO], [layer("a")])).toEqual([null]);
    link.isUp = true;
    expect((await heights.at([GANDO], [layer("a")]))[0]).toBeCloseTo(40, 3);
  });
});
