import { afterEach, expect, test, vi } from "vitest";
import { type FlatLayer, FlatTiles } from "./FlatTiles";
import type { FlatView } from "./projection";

const GANDO = { latitude_deg: 27.93, longitude_deg: -15.38 };
const WORLD = { west_deg: -180, south_deg: -90, east_deg: 180, north_deg: 90 };
const OPEN = { ...WORLD, minimum_zoom: 0, maximum_zoom: 18, opacity: 1 };
const context = { globalAlpha: 1, drawImage: () => undefined } as unknown as CanvasRenderingContext2D;

/** What the tiles ask for, address by address. */
function asking(): { readonly tiles: FlatTiles; readonly asked: string[] } {
  const asked: string[] = [];
  vi.stubGlobal(
    "Image",
    class {
      set src(address: string) {
        asked.push(address);
      }
    },
  );
  return { tiles: new FlatTiles(() => undefined), asked };
}

function layer(name: string, more: Partial<FlatLayer> = {}): FlatLayer {
  return { ...OPEN, url: `/${name}/{z}/{x}/{y}`, ...more };
}

afterEach(() => vi.unstubAllGlobals());

test("several layers on a great screen are asked for once, however many tiles that are", () => {
  const { tiles, asked } = asking();
  const view: FlatView = { centre: GANDO, zoom: 12.55, width_px: 3840, height_px: 2160 };
  const layers = ["a", "b", "c", "d"].map((name) => layer(name));
  tiles.draw(context, view, layers);
  const once = asked.length;
  expect(once).toBeGreaterThan(400);
  tiles.draw(context, view, layers);
  expect(asked.length).toBe(once);
});

test("what was seen lately is kept, what was seen long ago is asked for again", () => {
  const { tiles, asked } = asking();
  const at = (longitude_deg: number): FlatView => ({
    centre: { latitude_deg: 0, longitude_deg },
    zoom: 12,
    width_px: 1000,
    height_px: 1000,
  });
  const home = at(0);
  tiles.draw(context, home, [layer("a")]);
  const first = asked.length;
  for (let step = 1; step <= 40; step += 1) {
    tiles.draw(context, at(step), [layer("a")]);
    tiles.draw(context, home, [layer("a")]);
  }
  expect(asked.filter((address) => asked.indexOf(address) < first)).toHaveLength(first);
  for (let step = 1; step <= 40; step += 1) {
    tiles.draw(context, at(-step), [layer("a")]);
  }
  const before = asked.length;
  tiles.draw(context, home, [layer("a")]);
  expect(asked.length - before).toBe(first);
});

test("nothing is asked for where the layer has nothing, nor above its first level", () => {
  const { tiles, asked } = asking();
  const view: FlatView = { centre: GANDO, zoom: 10, width_px: 1000, height_px: 1000 };
  const island = { west_deg: -15.9, south_deg: 27.7, east_deg: -15.3, north_deg: 28.2 };
  tiles.draw(context, view, [layer("a", island)]);
  // A tile is 0.35 degrees wide: columns from 466.8 to 468.5 and rows from 428.2 to 429.8.
  expect([...asked].sort()).toEqual(
    [466, 467, 468].flatMap((column) => [428, 429].map((row) => `/a/10/${column}/${row}`)),
  );
  const before = asked.length;
  tiles.draw(context, view, [layer("b", { minimum_zoom: 11 })]);
  expect(asked.length).toBe(before);
});
