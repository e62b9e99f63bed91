import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { distance_m } from "../../lib/geodesy";
import { DrawnContext, DrawnPath } from "../../test/drawnContext";
import { askWorld } from "../../test/worldMap";
import { GROUND } from "../look";
import { answerOf } from "./answer";
import { CellStore } from "./cellStore";
import type { WorldQuestion } from "./messages";
import type { NamedThing, NearAirfield } from "./things";

const GANDO = { latitude_deg: 27.93, longitude_deg: -15.387 };

/** The map that ships with the page, read from its folder. */
const store = new CellStore(askWorld);

let contexts: (DrawnContext | null)[] = [];
let hasCanvas = true;

beforeEach(() => {
  contexts = [];
  hasCanvas = true;
  vi.stubGlobal("Path2D", DrawnPath);
  vi.stubGlobal(
    "OffscreenCanvas",
    class {
      getContext(): DrawnContext | null {
        const context = hasCanvas ? new DrawnContext() : null;
        contexts.push(context);
        return context;
      }
      transferToImageBitmap(): string {
        return "upright";
      }
    },
  );
  vi.stubGlobal("createImageBitmap", (_: unknown, { imageOrientation }: ImageBitmapOptions) =>
    Promise.resolve(imageOrientation),
  );
});
afterEach(() => vi.unstubAllGlobals());

/** The globe's tile of 5.6 degrees with Gran Canaria in it. */
const TILE: Extract<WorldQuestion, { kind: "tile" }> = {
  kind: "tile",
  tile: { projection: "geographic", level: 5, x: 29, y: 11 },
  light: "night",
  opacity: 1,
  isFlipped: false,
};

function colours(): readonly string[] {
  return [...new Set((contexts[0]?.drawn ?? []).map(({ colour }) => colour))];
}

describe("a tile that is asked for", () => {
  test("shows land and coast in the light that was asked for", async () => {
    expect(await answerOf(store, TILE)).toBe("upright");
    expect(colours()).toEqual([GROUND.night.sea, GROUND.night.land, GROUND.night.border, GROUND.night.coast]);
  });

  test("for the graphics is upside down", async () => {
    expect(await answerOf(store, { ...TILE, isFlipped: true })).toBe("flipY");
  });

  test("is refused where the browser draws none beside the page", async () => {
    hasCanvas = false;
    await expect(answerOf(store, TILE)).rejects.toThrow("draws no pictures beside the page");
  });
});

describe("the names around a place", () => {
  const zones = [
    { level: 2, from_m: 0, to_m: 30_000 },
    { level: 1, from_m: 30_000, to_m: 120_000 },
  ] as const;

  test("are those of its zones, the highest ranks first and no more than asked for", async () => {
    const question = { kind: "things", centre: GANDO, zones, sight_m: 20_000 } as const;
    const all = (await answerOf(store, { ...question, most: 500 })) as NamedThing[];
    expect(all.some((thing) => thing.kind === "airfield" && thing.airfield.code === "GCLP")).toBe(true);
    expect(all.some((thing) => thing.kind === "town" && thing.name === "Telde")).toBe(true);
    expect(all.every((thing) => distance_m(GANDO, thing) < 120_000)).toBe(true);
    expect(all.some((thing) => distance_m(GANDO, thing) > 30_000)).toBe(true);
    const few = (await answerOf(store, { ...question, most: 5 })) as NamedThing[];
    expect(few).toEqual(all.slice(0, 5));
    const ranks = few.map(({ rank }) => rank);
    expect(ranks).toEqual([...ranks].sort((one, other) => other - one));
  });
});

describe("the airfields near a place", () => {
  test("are the nearest for aircraft with wheels, the nearest first", async () => {
    const near = (await answerOf(store, { kind: "near", place: GANDO, most: 3 })) as NearAirfield[];
    expect(near).toHaveLength(3);
    expect(near[0]?.airfield.code).toBe("GCLP");
    expect(near[0]?.away_m).toBeLessThan(500);
    const away = near.map(({ away_m }) => away_m);
    expect(away).toEqual([...away].sort((one, other) => one - other));
    expect(near.every(({ airfield }) => airfield.weight >= 2)).toBe(true);
  });

  test("are looked for farther away over the sea, and are few or none where there is no land", async () => {
    // Four degrees west of El Hierro: the square around it holds nothing.
    const atSea = { latitude_deg: 28, longitude_deg: -22 };
    const near = (await answerOf(store, { kind: "near", place: atSea, most: 1 })) as NearAirfield[];
    expect(near.map(({ airfield }) => airfield.code)).toEqual(["GCHI"]);
    expect(near[0]?.away_m).toBeGreaterThan(300_000);
    const nowhere = { latitude_deg: -48, longitude_deg: -123 };
    expect(await answerOf(store, { kind: "near", place: nowhere, most: 4 })).toEqual([]);
  });
});

describe("an airfield that is asked for by its code", () => {
  test("is found a little beside its place, with its runways", async () => {
    const place = { ...GANDO, latitude_deg: GANDO.latitude_deg + 0.02 };
    const [found, ...others] = (await answerOf(store, {
      kind: "airfield",
      place,
      code: "GCLP",
    })) as NearAirfield[];
    expect(others).toEqual([]);
    expect(found?.away_m).toBeGreaterThan(1500);
    expect(found?.away_m).toBeLessThan(3500);
    expect(found?.airfield.runways).toHaveLength(2);
  });

  test("is none where no airfield has that code", async () => {
    expect(await answerOf(store, { kind: "airfield", place: GANDO, code: "LEMD" })).toEqual([]);
  });
});
