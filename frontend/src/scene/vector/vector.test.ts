import { expect, test } from "vitest";
import { drawVector, isDrawnLayer, namesOf } from "./drawVector";
import { sourceOf, VectorTiles } from "./VectorTiles";
import { decodeVectorTile, type VectorLayer } from "./vectorTile";

const WHOLE = { left: 0, top: 0, share: 1 };

function varint(value: number): number[] {
  return value < 128 ? [value] : [(value % 128) | 128, ...varint(Math.floor(value / 128))];
}
const zigzag = (value: number): number => (value < 0 ? -2 * value - 1 : 2 * value);
const bytesOf = (number: number, data: readonly number[]): number[] => [
  number * 8 + 2,
  ...varint(data.length),
  ...data,
];
const text = (value: string): number[] => [...new TextEncoder().encode(value)];

/** A layer with one feature whose geometry is these numbers. */
function layer(
  name: string,
  kind: number,
  geometry: readonly number[],
  tags: Record<string, string> = {},
): number[] {
  const numbers = Object.keys(tags).flatMap((_, index) => [index, index]);
  const feature = [...bytesOf(2, numbers), 24, kind, ...bytesOf(4, geometry.flatMap(varint))];
  return bytesOf(3, [
    ...[120, 2],
    ...bytesOf(1, text(name)),
    ...bytesOf(2, feature),
    ...Object.keys(tags).flatMap((key) => bytesOf(3, text(key))),
    ...Object.values(tags).flatMap((value) => bytesOf(4, bytesOf(1, text(value)))),
    ...[40, ...varint(4096)],
  ]);
}
const LINE = [9, zigzag(0), zigzag(2048), 18, zigzag(2048), zigzag(-1024), zigzag(2048), zigzag(1024)];
const SQUARE = [9, 0, 0, 26, zigzag(1024), 0, 0, zigzag(1024), zigzag(-1024), 0, 15];
const ROAD = { class: "primary", ref: "GC-1" };

function decoded(...layers: readonly number[][]): VectorLayer[] {
  return decodeVectorTile(new Uint8Array(layers.flat()), isDrawnLayer);
}

test("roads and areas are read in shares of the tile, and layers that are not drawn are left out", () => {
  const [roads, building, ...rest] = decoded(
    layer("transportation", 2, LINE, ROAD),
    layer("building", 3, SQUARE),
    layer("poi", 1, [9, 0, 0]),
    layer("constructor", 1, [9, 0, 0]),
  );
  expect(rest).toEqual([]);
  expect(roads?.features[0]).toEqual({
    kind: "line",
    shapes: [[0, 0.5, 0.5, 0.25, 1, 0.5]],
    tags: new Map(Object.entries(ROAD)),
  });
  expect(building?.features[0]?.shapes).toEqual([[0, 0, 0.25, 0, 0.25, 0.25, 0, 0.25, 0, 0]]);
});

test("a few bytes that claim millions of points make no more than they hold", () => {
  const claims = [9, 0, 0, 2 ** 29 * 8 + 2, 2, 2];
  expect(decoded(layer("transportation", 2, claims))[0]?.features[0]?.shapes).toHaveLength(1);
  // Closing a ring takes no bytes: done once for each command, however often it is said to be.
  const closes = [...SQUARE, 2 ** 28 * 8 + 7];
  expect(decoded(layer("building", 3, closes))[0]?.features[0]?.shapes[0]).toHaveLength(12);
});

test("what is cut or no vector tile is refused, wherever it ends", () => {
  const bytes = layer("transportation", 2, LINE, ROAD);
  for (let end = 1; end < bytes.length; end += 1) {
    expect(() => decodeVectorTile(new Uint8Array(bytes.slice(0, end)), isDrawnLayer)).toThrow();
  }
  expect(() => decodeVectorTile(new Uint8Array(text("<html>hello</html>")), isDrawnLayer)).toThrow();
});

test("a part of a tile is drawn over the whole picture, by day and by night in other colours", () => {
  const layers = decoded(layer("transportation", 2, LINE, ROAD));
  const drawn = (light: "day" | "night"): { places: number[][]; colours: string[] } => {
    const places: number[][] = [];
    const colours: string[] = [];
    const nothing = (): void => undefined;
    drawVector(
      {
        beginPath: nothing,
        fill: nothing,
        stroke: nothing,
        setLineDash: nothing,
        moveTo: (x: number, y: number) => void places.push([x, y]),
        lineTo: (x: number, y: number) => void places.push([x, y]),
        set strokeStyle(colour: string) {
          colours.push(colour);
        },
        fillStyle: "",
        lineWidth: 1,
        lineJoin: "round",
        lineCap: "round",
      },
      layers,
      { left: 0.5, top: 0, share: 0.5 },
      512,
      15,
      light,
    );
    return { places, colours };
  };
  expect(drawn("day").places[1]).toEqual([0, 256]);
  expect(drawn("day").colours).not.toEqual(drawn("night").colours);
});

test("a name stands at the middle of its longest line, once, and only in the part where that is", () => {
  const layers = decoded(
    layer("transportation_name", 2, LINE, { class: "primary", ref: "GC-1", name: "Autovia" }),
    layer("waterway", 2, LINE, { name: "Barranco" }),
    layer("transportation_name", 2, LINE, { class: "primary", ref: "GC-1" }),
  );
  expect(namesOf(layers, WHOLE).map(({ text, x, y }) => [text, x, y])).toEqual([
    ["GC-1", 0.5, 0.25],
    ["Barranco", 0.5, 0.25],
  ]);
  expect(namesOf(layers, { left: 0, top: 0.5, share: 0.5 })).toEqual([]);
});

test("nearer than the source's finest level a part of its tile is shown", () => {
  expect(sourceOf("/l/{z}/{x}/{y}", 14, 16, 7, 9)).toEqual({
    url: "/l/14/1/2",
    part: { left: 0.75, top: 0.25, share: 0.25 },
  });
  expect(sourceOf("/l/{z}/{x}/{y}", 14, 12, 7, 9).url).toBe("/l/12/7/9");
});

test("a tile is asked for once, none where there is none, and again after a failure", async () => {
  const answers = [
    new Response(null, { status: 500 }),
    new Response(new Uint8Array(layer("transportation", 2, LINE, ROAD))),
    new Response(null, { status: 204 }),
  ];
  const asked: string[] = [];
  const tiles = new VectorTiles((address) => {
    asked.push(address);
    return Promise.resolve(answers.shift() ?? Response.error());
  });
  await expect(tiles.at("/a")).rejects.toThrow("500");
  expect(await tiles.at("/a")).toHaveLength(1);
  expect(await tiles.at("/a")).toHaveLength(1);
  expect(await tiles.at("/b")).toBeNull();
  expect(asked).toEqual(["/a", "/a", "/b"]);
});
