import { expect, test, vi } from "vitest";
import type { WorldQuestion } from "../../world/messages";
import type { World } from "../../world/World";
import { WorldTiles } from "./WorldTiles";

type TileQuestion = Extract<WorldQuestion, { kind: "tile" }>;

/** A map whose tiles are drawn, or fail, when the test says so. */
function tilesOf(light: "day" | "night") {
  const asked: { of: TileQuestion; draw: () => void; fail: () => void }[] = [];
  const world = {
    ask: (of: TileQuestion) =>
      new Promise((resolve, reject) => {
        asked.push({ of, draw: () => resolve("picture"), fail: () => reject(new Error("cut off")) });
      }),
  };
  const drawn = vi.fn();
  return { tiles: new WorldTiles(world as unknown as World, light, drawn), asked, drawn };
}

test("a tile of the chart is asked for at its place, upside down for the graphics", async () => {
  const { tiles, asked, drawn } = tilesOf("day");
  const picture = tiles.requestImage(29, 11, 5);
  expect(asked[0]?.of).toMatchObject({
    tile: { projection: "geographic", level: 5, x: 29, y: 11 },
    light: "day",
    isFlipped: true,
  });
  expect(drawn).not.toHaveBeenCalled();
  asked[0]?.draw();
  expect(await picture).toBe("picture");
  expect(drawn).toHaveBeenCalledOnce();
});

test("by day the picture of the Earth shows through from afar and not from near, at night never", () => {
  const opacities = (light: "day" | "night"): number[] => {
    const { tiles, asked } = tilesOf(light);
    for (const level of [0, 3, 5, 6, 18]) {
      void tiles.requestImage(0, 0, level);
    }
    return asked.map(({ of }) => of.opacity);
  };
  const day = opacities("day");
  expect(day[0]).toBeLessThan(0.3);
  expect(day).toEqual([...day].sort((one, other) => one - other));
  expect(day.slice(3)).toEqual([1, 1]);
  expect(opacities("night")).toEqual([1, 1, 1, 1, 1]);
});

test("no more than six tiles are drawn at once, and one that fails makes room too", async () => {
  const { tiles, asked, drawn } = tilesOf("day");
  const pictures = Array.from({ length: 7 }, (_, x) => tiles.requestImage(x, 0, 6));
  expect(pictures.map((picture) => picture === undefined)).toEqual([...Array(6).fill(false), true]);
  asked[0]?.fail();
  await expect(pictures[0]).rejects.toThrow("cut off");
  expect(drawn).toHaveBeenCalledOnce();
  expect(tiles.requestImage(7, 0, 6)).toBeDefined();
  expect(tiles.requestImage(8, 0, 6)).toBeUndefined();
});
